#include "mesh/geometry/triangle_intersection.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

int sign(double x) { return (x > 0) - (x < 0); }

using Signs = std::array<int, 3>;

/// On which side of the plane of t the corners of s lie.
Signs sides(const TrianglePoints& t, const TrianglePoints& s) {
  return {sign(orient3d(t[0], t[1], t[2], s[0])), sign(orient3d(t[0], t[1], t[2], s[1])),
          sign(orient3d(t[0], t[1], t[2], s[2]))};
}

bool all_zero(const Signs& s) { return s[0] == 0 && s[1] == 0 && s[2] == 0; }
bool one_strict_side(const Signs& s) { return s[0] != 0 && s[0] == s[1] && s[0] == s[2]; }
bool straddles(const Signs& s) {
  const auto [low, high] = std::minmax({s[0], s[1], s[2]});
  return low < 0 && high > 0;
}

Vec2 without(const Vec3& p, int axis) {
  return axis == 0 ? Vec2{p.y, p.z} : axis == 1 ? Vec2{p.z, p.x} : Vec2{p.x, p.y};
}

using FlatTriangle = std::array<Vec2, 3>;

FlatTriangle without(const TrianglePoints& t, int axis) {
  return {without(t[0], axis), without(t[1], axis), without(t[2], axis)};
}

/// An axis along which t can be flattened and keeps its area; -1 when t has none. Any such axis
/// keeps every answer about points in the plane of t.
int flattening_axis(const TrianglePoints& t) {
  for (const int axis : {2, 0, 1}) {
    const FlatTriangle f = without(t, axis);
    if (orient2d(f[0], f[1], f[2]) != 0) return axis;
  }
  return -1;
}

FlatTriangle anticlockwise(FlatTriangle f) {
  if (orient2d(f[0], f[1], f[2]) < 0) std::swap(f[1], f[2]);
  return f;
}

/// Where the points lie of the line uv: the highest of their signs (positive: inside).
template <std::size_t n>
int highest_side(const Vec2& u, const Vec2& v, const std::array<Vec2, n>& points) {
  int highest = -1;
  for (const Vec2& p : points) {
    highest = std::max(highest, sign(orient2d(u, v, p)));
    if (highest > 0) break;
  }
  return highest;
}

/// The least, over the edges of t (anticlockwise), of how far the points reach inside: negative, an
/// edge of t separates them strictly; 0, they touch at most; positive, no edge of t separates them.
template <std::size_t n>
int least_reach(const FlatTriangle& t, const std::array<Vec2, n>& points) {
  int least = 1;
  for (std::size_t i = 0; i < 3 && least >= 0; ++i) {
    least = std::min(least, highest_side(t[i], t[(i + 1) % 3], points));
  }
  return least;
}

TriangleContact contact_in_plane(const TrianglePoints& a, const TrianglePoints& b) {
  const int axis = flattening_axis(a);
  if (axis < 0) return TriangleContact::none;
  const FlatTriangle fa = anticlockwise(without(a, axis));
  const FlatTriangle fb = anticlockwise(without(b, axis));
  const int least = std::min(least_reach(fa, fb), least_reach(fb, fa));
  return least < 0    ? TriangleContact::none
         : least == 0 ? TriangleContact::touching
                      : TriangleContact::overlapping;
}

/// @pre p and q lie in the plane of t. They may be equal.
bool segment_meets_triangle_in_plane(const Vec3& p, const Vec3& q, const TrianglePoints& t) {
  const int axis = flattening_axis(t);
  if (axis < 0) return false;
  const FlatTriangle f = anticlockwise(without(t, axis));
  const Vec2 u = without(p, axis);
  const Vec2 v = without(q, axis);
  if (least_reach(f, std::array<Vec2, 2>{u, v}) < 0) return false;
  return highest_side(u, v, f) >= 0 && highest_side(v, u, f) >= 0;
}

/// How the line pq passes the edges of t: the signs of its turns round them. All of one sign or 0:
/// it meets t.
Signs turns(const Vec3& p, const Vec3& q, const TrianglePoints& t) {
  return {sign(orient3d(p, q, t[0], t[1])), sign(orient3d(p, q, t[1], t[2])),
          sign(orient3d(p, q, t[2], t[0]))};
}

bool edge_meets(const TrianglePoints& a, const TrianglePoints& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (segment_meets_triangle(a[i], a[(i + 1) % 3], b)) return true;
  }
  return false;
}

/// A triangle turned so that corner 0 is alone on its side of the other's plane; the others are on
/// the other side, at most one of them on the plane.
struct Straddling {
  TrianglePoints points;
  Signs side;
};

Straddling apex_first(const TrianglePoints& t, const Signs& s) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    if (s[i] != 0 && s[j] != s[i] && s[k] != s[i]) return {{t[i], t[j], t[k]}, {s[i], s[j], s[k]}};
  }
  return {t, s};
}

void swap_last(Straddling& t) {
  std::swap(t.points[1], t.points[2]);
  std::swap(t.side[1], t.side[2]);
}

/// Both triangles cut the line where their planes meet in an interval; `crossing` when the open
/// intervals overlap. @pre both straddle the plane of the other.
TriangleContact contact_of_straddling(Straddling a, Straddling b) {
  TF_CHECK(a.side[0] != 0 && b.side[0] != 0);
  // Orient each so that the other's apex is on its positive side; the side signs are not needed
  // beyond being 0 or not.
  if (a.side[0] < 0) swap_last(b);
  if (b.side[0] < 0) swap_last(a);
  const auto& p = a.points;
  const auto& q = b.points;
  const int first = sign(orient3d(p[0], p[1], q[0], q[1]));
  if (first > 0) return TriangleContact::none;
  const int second = sign(orient3d(p[0], p[2], q[2], q[0]));
  if (second > 0) return TriangleContact::none;
  // At 0 the intervals only share an end, where an edge of a meets an edge of b.
  const bool first_edges_cross = a.side[1] != 0 && b.side[1] != 0;
  const bool second_edges_cross = a.side[2] != 0 && b.side[2] != 0;
  if ((first == 0 && !first_edges_cross) || (second == 0 && !second_edges_cross)) {
    return TriangleContact::touching;
  }
  return TriangleContact::crossing;
}

/// Shared corners first in both, in the same order; `shared` of them.
struct MatchedTriangles {
  Triangle a;
  Triangle b;
  std::size_t shared = 0;
};

MatchedTriangles match_corners(const Triangle& a, const Triangle& b) {
  MatchedTriangles m{a, b, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto from = m.b.begin() + static_cast<std::ptrdiff_t>(m.shared);
    const auto it = std::find(from, m.b.end(), m.a[i]);
    if (it == m.b.end()) continue;
    std::iter_swap(from, it);
    std::swap(m.a[m.shared], m.a[i]);
    ++m.shared;
  }
  return m;
}

/// Whether triangles on the common edge (u, v) with the other corners p and q are folded flat onto
/// each other.
bool folded_flat(const Vec3& u, const Vec3& v, const Vec3& p, const Vec3& q) {
  if (orient3d(u, v, p, q) != 0) return false;
  const int axis = flattening_axis({u, v, p});
  if (axis < 0) return false;
  const Vec2 from = without(u, axis);
  const Vec2 to = without(v, axis);
  return sign(orient2d(from, to, without(p, axis))) == sign(orient2d(from, to, without(q, axis)));
}

}  // namespace

TriangleContact triangle_contact(const TrianglePoints& a, const TrianglePoints& b) {
  const Signs a_sides = sides(b, a);
  if (one_strict_side(a_sides)) return TriangleContact::none;
  const Signs b_sides = sides(a, b);
  if (one_strict_side(b_sides)) return TriangleContact::none;
  if (is_degenerate(a) || is_degenerate(b)) return TriangleContact::none;
  if (all_zero(a_sides)) return contact_in_plane(a, b);
  if (straddles(a_sides) && straddles(b_sides)) {
    return contact_of_straddling(apex_first(a, a_sides), apex_first(b, b_sides));
  }
  return edge_meets(a, b) || edge_meets(b, a) ? TriangleContact::touching : TriangleContact::none;
}

bool triangles_meet_beyond_shared(std::span<const Vec3> vertices, const Triangle& a,
                                  const Triangle& b) {
  const MatchedTriangles m = match_corners(a, b);
  const TrianglePoints p = triangle_points(vertices, m.a);
  const TrianglePoints q = triangle_points(vertices, m.b);
  switch (m.shared) {
    case 0:
      return triangle_contact(p, q) != TriangleContact::none;
    case 1:
      // The common points form a convex set round the shared corner: if there is more than the
      // corner, some of it lies on the edge opposite the corner in a or in b.
      return segment_meets_triangle(p[1], p[2], q) || segment_meets_triangle(q[1], q[2], p);
    case 2:
      return folded_flat(p[0], p[1], p[2], q[2]);
    default:
      return true;
  }
}

bool segment_meets_triangle(const Vec3& p, const Vec3& q, const TrianglePoints& t) {
  const int at_p = sign(orient3d(t[0], t[1], t[2], p));
  const int at_q = sign(orient3d(t[0], t[1], t[2], q));
  if (at_p * at_q > 0) return false;
  if (at_p == 0 && at_q == 0) return segment_meets_triangle_in_plane(p, q, t);
  if (at_p == 0) return segment_meets_triangle_in_plane(p, p, t);
  if (at_q == 0) return segment_meets_triangle_in_plane(q, q, t);
  const Signs turn = turns(p, q, t);
  const auto [low, high] = std::minmax({turn[0], turn[1], turn[2]});
  return low >= 0 || high <= 0;
}

bool segment_crosses_triangle(const Vec3& p, const Vec3& q, const TrianglePoints& t) {
  const int at_p = sign(orient3d(t[0], t[1], t[2], p));
  if (at_p == 0) return false;
  if (at_p * sign(orient3d(t[0], t[1], t[2], q)) >= 0) return false;
  const Signs turn = turns(p, q, t);
  const auto [low, high] = std::minmax({turn[0], turn[1], turn[2]});
  return (low >= 0 || high <= 0) && std::count(turn.begin(), turn.end(), 0) <= 1;
}

bool is_degenerate(const TrianglePoints& t) { return flattening_axis(t) < 0; }

}  // namespace tetfarm
