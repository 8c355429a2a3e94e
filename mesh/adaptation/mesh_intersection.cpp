#include "mesh/adaptation/mesh_intersection.h"

#include <algorithm>
#include <cstddef>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/adaptation/checked_plane_mesh.h"

namespace tetfarm {
namespace {

using Corners = std::array<Vec2, 3>;

struct CutCorner {
  Vec2 place;
  std::array<double, 3> shares{};
};

/// Three corners become four by the first side, six by the second and nine by the third at most,
/// even where rounding makes the polygon cross a side more than twice.
struct CutPolygon {
  std::array<CutCorner, 9> corners;
  std::size_t count = 0;
  void add(const CutCorner& corner) {
    TF_CHECK(count < corners.size());
    corners[count++] = corner;
  }
};

double signed_double_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

CutCorner between(const CutCorner& a, const CutCorner& b, double share) {
  CutCorner corner;
  const auto mean = [share](double of_a, double of_b) { return of_a + share * (of_b - of_a); };
  corner.place = {mean(a.place.x, b.place.x), mean(a.place.y, b.place.y)};
  for (std::size_t k = 0; k < 3; ++k) corner.shares[k] = mean(a.shares[k], b.shares[k]);
  return corner;
}

/// What lies to the left of the line from a to b.
CutPolygon left_of(const CutPolygon& polygon, const Vec2& a, const Vec2& b) {
  CutPolygon left;
  for (std::size_t k = 0; k < polygon.count; ++k) {
    const CutCorner& here = polygon.corners[k];
    const CutCorner& after = polygon.corners[k + 1 < polygon.count ? k + 1 : 0];
    const double height = signed_double_area(a, b, here.place);
    const double height_after = signed_double_area(a, b, after.place);
    if (height >= 0) left.add(here);
    if ((height > 0 && height_after < 0) || (height < 0 && height_after > 0)) {
      left.add(between(here, after, height / (height - height_after)));
    }
  }
  return left;
}

IntersectionPiece integrals_over(const CutPolygon& polygon) {
  IntersectionPiece piece;
  for (std::size_t k = 2; k < polygon.count; ++k) {
    const CutCorner& a = polygon.corners[0];
    const CutCorner& b = polygon.corners[k - 1];
    const CutCorner& c = polygon.corners[k];
    const double area = signed_double_area(a.place, b.place, c.place) / 2;
    piece.area += area;
    piece.moment.x += area * (a.place.x + b.place.x + c.place.x) / 3;
    piece.moment.y += area * (a.place.y + b.place.y + c.place.y) / 3;
    for (std::size_t i = 0; i < 3; ++i) {
      piece.shares[i] += area * (a.shares[i] + b.shares[i] + c.shares[i]) / 3;
    }
  }
  return piece;
}

/// A side of `triangle` has the other one wholly beyond it.
bool has_side_before(const Corners& triangle, const Corners& other) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2& a = triangle[i];
    const Vec2& b = triangle[(i + 1) % 3];
    if (orient2d(a, b, other[0]) < 0 && orient2d(a, b, other[1]) < 0 &&
        orient2d(a, b, other[2]) < 0) {
      return true;
    }
  }
  return false;
}

bool are_boxes_apart(const Corners& a, const Corners& b) {
  const auto apart = [&](double Vec2::*axis) {
    const auto [low_a, high_a] = std::minmax({a[0].*axis, a[1].*axis, a[2].*axis});
    const auto [low_b, high_b] = std::minmax({b[0].*axis, b[1].*axis, b[2].*axis});
    return high_a < low_b || high_b < low_a;
  };
  return apart(&Vec2::x) || apart(&Vec2::y);
}

/// Two triangles are apart when a side of one separates them.
bool do_touch(const Corners& a, const Corners& b) {
  return !are_boxes_apart(a, b) && !has_side_before(a, b) && !has_side_before(b, a);
}

}  // namespace

IntersectionPiece intersection_of(const std::array<Vec2, 3>& background,
                                  const std::array<Vec2, 3>& other) {
  // From a node of the triangle: far from the origin digits would be lost.
  const auto from_node = [&](const Vec2& p) { return Vec2{p.x - other[0].x, p.y - other[0].y}; };
  CutPolygon polygon;
  for (std::size_t i = 0; i < 3; ++i) {
    CutCorner corner{from_node(background[i]), {}};
    corner.shares[i] = 1;
    polygon.add(corner);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    polygon = left_of(polygon, from_node(other[i]), from_node(other[(i + 1) % 3]));
  }
  const IntersectionPiece piece = integrals_over(polygon);
  return piece.area > 0 ? piece : IntersectionPiece{};
}

MeshIntersection::MeshIntersection(const TriangleComplex& background, const TriangleComplex& target,
                                   std::int64_t most_pairs)
    : background_(background),
      target_(target),
      stamps_(background.triangles.size(), 0),
      most_pairs_(most_pairs) {
  pairs_left_ =
      most_pairs * static_cast<std::int64_t>(background.triangles.size() + target.triangles.size());
}

std::array<Vec2, 3> MeshIntersection::corners_of(const TriangleComplex& complex,
                                                 std::int32_t triangle) const {
  const TriangleComplex::Nodes& n = complex.nodes(triangle);
  return {complex.point(n[0]), complex.point(n[1]), complex.point(n[2])};
}

void MeshIntersection::reach(std::int32_t triangle) {
  if (stamps_[at(triangle)] == stamp_) return;
  stamps_[at(triangle)] = stamp_;
  reached_.push_back(triangle);
}

std::span<const IntersectionPiece> MeshIntersection::pieces_of(
    std::int32_t triangle, std::span<const std::int32_t> seeds) {
  TF_CHECK(triangle >= 0 && triangle < target_.size());
  const Corners other = corners_of(target_, triangle);
  pieces_.clear();
  reached_.clear();
  ++stamp_;
  for (const std::int32_t seed : seeds) reach(seed);
  for (std::size_t k = 0; k < reached_.size(); ++k) {
    if (--pairs_left_ < 0) {
      throw InvalidInput("the triangles of the two meshes lie across each other: more than " +
                             std::to_string(most_pairs_) +
                             " of one mesh in each of the other, on average",
                         "triangle at " + place_text(other[0]));
    }
    const std::int32_t t = reached_[k];
    const Corners background = corners_of(background_, t);
    if (!do_touch(background, other)) continue;
    IntersectionPiece piece = intersection_of(background, other);
    piece.triangle = t;
    if (piece.area > 0) pieces_.push_back(piece);
    for (int i = 0; i < 3; ++i) {
      const EdgeHandle beyond = background_.neighbour(t, i);
      if (beyond != no_edge) reach(triangle_of(beyond));
    }
  }
  return pieces_;
}

}  // namespace tetfarm
