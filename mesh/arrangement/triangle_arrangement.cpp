#include "mesh/arrangement/triangle_arrangement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "base/array_index.h"
#include "base/disjoint_sets.h"
#include "mesh/arrangement/constrained_triangulation.h"
#include "mesh/arrangement/exact_points.h"
#include "mesh/arrangement/layer_merging.h"
#include "mesh/arrangement/snap_to_neighbours.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/predicates.h"
#include "mesh/geometry/triangle_intersection.h"

namespace tetfarm {
namespace {

constexpr int most_rounds = 60;
/// Pairs of segments in a round, beside some for each triangle: 50 µs each, with the pieces that
/// come of them.
constexpr std::int64_t most_pairs = 1'000'000;
constexpr std::int64_t most_pairs_a_triangle = 50;

/// Which corners lie in front of the plane (1), behind it (-1), on it (0).
std::array<int, 3> sides_of_corners(const TrianglePoints& plane, const TrianglePoints& corners) {
  std::array<int, 3> sides{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = orient3d(plane[0], plane[1], plane[2], corners[k]);
    sides[k] = (side > 0) - (side < 0);
  }
  return sides;
}

bool are_coplanar(const TrianglePoints& a, const TrianglePoints& b) {
  return sides_of_corners(a, b) == std::array<int, 3>{0, 0, 0};
}

/// An axis along which the triangle is seen not edge-on, and the largest. @pre it has area.
int widest_axis(const TrianglePoints& t) {
  int widest = 0;
  double largest = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const auto seen = [axis](const Vec3& p) { return Vec2{p[(axis + 1) % 3], p[(axis + 2) % 3]}; };
    const double area = std::abs(orient2d(seen(t[0]), seen(t[1]), seen(t[2])));
    if (area > largest) {
      largest = area;
      widest = axis;
    }
  }
  return widest;
}

/// A triangle in the plane that is divided, exactly.
struct PlaneTriangle {
  std::int32_t number = 0;
  std::array<ExactPoint, 3> corners;
  int facing = 0;  ///< 1: anticlockwise as seen along the axis of the plane, -1: clockwise
};

/// The part of a segment in the plane that lies in the triangle; one point twice where that is all.
std::optional<std::array<ExactPoint, 2>> clip(std::array<ExactPoint, 2> segment,
                                              const PlaneTriangle& triangle, int axis) {
  for (std::size_t k = 0; k < 3; ++k) {
    const ExactPoint& from = triangle.corners[k];
    const ExactPoint& to = triangle.corners[(k + 1) % 3];
    const bool is_first_out = seen_turn(from, to, segment[0], axis) * triangle.facing < 0;
    const bool is_second_out = seen_turn(from, to, segment[1], axis) * triangle.facing < 0;
    if (is_first_out && is_second_out) return std::nullopt;
    if (!is_first_out && !is_second_out) continue;
    const mpq_class first = seen_area(from, to, segment[0], axis);
    const mpq_class second = seen_area(from, to, segment[1], axis);
    ExactPoint on = point_between(segment[0], segment[1], first / (first - second));
    (is_first_out ? segment[0] : segment[1]) = std::move(on);
  }
  return segment;
}

bool is_inside(const ExactPoint& p, const PlaneTriangle& triangle, int axis) {
  const std::array<ExactPoint, 3>& c = triangle.corners;
  return seen_turn(c[0], c[1], p, axis) == triangle.facing &&
         seen_turn(c[1], c[2], p, axis) == triangle.facing &&
         seen_turn(c[2], c[0], p, axis) == triangle.facing;
}

/// Where a triangle goes through the plane of another; nothing where it lies in that plane.
std::optional<std::array<ExactPoint, 2>> cut_by_plane(const TrianglePoints& triangle,
                                                      const TrianglePoints& plane) {
  const std::array<int, 3> side = sides_of_corners(plane, triangle);
  std::vector<ExactPoint> points;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (side[k] == 0) points.push_back(exact_point(triangle[k]));
    if (side[k] * side[next] < 0) {
      points.push_back(plane_crossing(triangle[k], triangle[next], plane));
    }
  }
  if (points.empty() || points.size() == 3) return std::nullopt;
  return std::array<ExactPoint, 2>{points.front(), points.back()};
}

/// One round: every triangle that meets others is divided, exactly; then new points are rounded.
class Round {
 public:
  Round(TriangleChain& chain, std::vector<TrianglePair> pairs)
      : chain_(chain),
        pairs_(std::move(pairs)),
        pairs_left_(most_pairs + most_pairs_a_triangle * std::ssize(chain.triangles)) {}

  bool divide() {
    gather_planes();
    std::vector<ChainTriangle> made;
    for (const std::vector<std::int32_t>& plane : planes_) {
      if (!divide_plane(plane, made)) return false;
    }
    put_in_place(made);
    return true;
  }

 private:
  /// Triangles that meet, those that overlap in one plane together.
  void gather_planes() {
    const std::size_t count = chain_.triangles.size();
    others_.resize(count);
    DisjointSets sets(count);
    for (const auto& [i, j] : pairs_) {
      others_[at(i)].push_back(j);
      others_[at(j)].push_back(i);
      if (are_coplanar(chain_.points_of(i), chain_.points_of(j))) sets.join(at(i), at(j));
    }
    std::vector<char> meets(count);
    for (std::size_t t = 0; t < count; ++t) meets[t] = others_[t].empty() ? 0 : 1;
    planes_ = groups_of_marked(sets, meets);
  }

  std::int32_t add_vertex(std::int32_t v) {
    const std::int32_t number = points_.add(exact_point(chain_.vertices[at(v)]));
    if (at(number) >= vertex_of_.size()) vertex_of_.resize(at(number) + 1, -1);
    if (vertex_of_[at(number)] < 0) vertex_of_[at(number)] = v;
    return number;
  }

  std::vector<PlaneTriangle> plane_triangles(const std::vector<std::int32_t>& plane, int axis) {
    std::vector<PlaneTriangle> triangles;
    for (const std::int32_t t : plane) {
      const TrianglePoints c = chain_.points_of(t);
      PlaneTriangle& made = triangles.emplace_back();
      made.number = t;
      made.corners = {exact_point(c[0]), exact_point(c[1]), exact_point(c[2])};
      made.facing = seen_turn(made.corners[0], made.corners[1], made.corners[2], axis);
    }
    return triangles;
  }

  /// The edges of the triangle, and what it has in common with those of other planes.
  void add_segments(const PlaneTriangle& triangle, int axis, std::vector<Segment>& segments) {
    const TrianglePoints corners = chain_.points_of(triangle.number);
    const Triangle& nodes = chain_.triangles[at(triangle.number)].nodes;
    const std::array<std::int32_t, 3> numbers = {add_vertex(nodes[0]), add_vertex(nodes[1]),
                                                 add_vertex(nodes[2])};
    for (std::size_t k = 0; k < 3; ++k) segments.push_back({numbers[k], numbers[(k + 1) % 3]});
    for (const std::int32_t other : others_[at(triangle.number)]) {
      auto cut = cut_by_plane(chain_.points_of(other), corners);
      if (cut) cut = clip(std::move(*cut), triangle, axis);
      if (!cut) continue;
      const std::int32_t first = points_.add(std::move((*cut)[0]));
      segments.push_back({first, points_.add(std::move((*cut)[1]))});
    }
  }

  bool divide_plane(const std::vector<std::int32_t>& plane, std::vector<ChainTriangle>& made) {
    const int axis = widest_axis(chain_.points_of(plane.front()));
    const std::vector<PlaneTriangle> triangles = plane_triangles(plane, axis);
    std::vector<Segment> segments;
    for (const PlaneTriangle& t : triangles) add_segments(t, axis, segments);
    const auto edges = divide_segments(points_, segments, axis, pairs_left_);
    if (!edges) return false;
    std::vector<std::int32_t> nodes;
    for (const Segment& s : *edges) nodes.insert(nodes.end(), s.begin(), s.end());
    // Points alone, which are in no piece.
    for (const Segment& s : segments) nodes.insert(nodes.end(), s.begin(), s.end());
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    const auto pieces = triangulate(points_, nodes, *edges, axis);
    if (!pieces) return false;
    share_out(triangles, *pieces, axis, made);
    return true;
  }

  /// Each small triangle is there as often as the triangles of the plane that it lies in.
  void share_out(const std::vector<PlaneTriangle>& plane, const std::vector<Triangle>& pieces,
                 int axis, std::vector<ChainTriangle>& made) {
    std::vector<Box3> boxes;
    for (const PlaneTriangle& t : plane) {
      Box3 box;
      for (const Vec3& p : chain_.points_of(t.number)) box.add(p);
      boxes.push_back(box);
    }
    const BoxTree tree(boxes);
    for (const Triangle& piece : pieces) {
      std::vector<Part> parts;
      if (plane.size() == 1) {
        parts.push_back({plane.front().number, plane.front().facing});
      } else {
        const ExactPoint middle = middle_of(piece);
        std::vector<std::int32_t> near;
        tree.query(box_round(middle), [&](std::int32_t i) { near.push_back(i); });
        std::ranges::sort(near);
        for (const std::int32_t i : near) {
          const PlaneTriangle& t = plane[at(i)];
          if (is_inside(middle, t, axis)) parts.push_back({t.number, t.facing});
        }
      }
      add_piece(piece, parts, made);
    }
  }

  /// A triangle that a piece lies in, and whether it is anticlockwise as the piece is (1) or not
  /// (-1).
  struct Part {
    std::int32_t triangle;
    int facing;
  };

  void add_piece(const Triangle& piece, const std::vector<Part>& parts,
                 std::vector<ChainTriangle>& made) const {
    ChainTriangle sum{piece, 0, 0, true, false};
    for (const Part& part : parts) {
      sum.times += part.facing * chain_.triangles[at(part.triangle)].times;
    }
    if (sum.times == 0) return;
    const auto first =
        std::ranges::find_if(parts, [&](const Part& part) { return part.facing * sum.times > 0; });
    if (first != parts.end()) sum.patch = chain_.triangles[at(first->triangle)].patch;
    if (sum.times < 0) {
      std::swap(sum.nodes[1], sum.nodes[2]);
      sum.times = -sum.times;
    }
    made.push_back(sum);
  }

  ExactPoint middle_of(const Triangle& t) const {
    const ExactPoint edge = point_between(points_[t[0]], points_[t[1]], mpq_class(1, 2));
    return point_between(edge, points_[t[2]], mpq_class(1, 3));
  }

  /// Triangles that meet none stay, in their order, then come those that were made.
  void put_in_place(std::vector<ChainTriangle>& made) {
    vertex_of_.resize(at(points_.size()), -1);
    for (ChainTriangle& t : made) {
      for (std::int32_t& n : t.nodes) n = vertex_at(n);
    }
    std::vector<ChainTriangle> after;
    for (std::size_t t = 0; t < chain_.triangles.size(); ++t) {
      if (others_[t].empty()) after.push_back(chain_.triangles[t]);
    }
    after.insert(after.end(), made.begin(), made.end());
    chain_.triangles = std::move(after);
  }

  std::int32_t vertex_at(std::int32_t point) {
    std::int32_t& vertex = vertex_of_[at(point)];
    if (vertex < 0) {
      vertex = static_cast<std::int32_t>(chain_.vertices.size());
      chain_.vertices.push_back(points_[point].near);
    }
    return vertex;
  }

  TriangleChain& chain_;
  std::vector<TrianglePair> pairs_;
  std::int64_t pairs_left_;  // of segments
  std::vector<std::vector<std::int32_t>> others_;
  std::vector<std::vector<std::int32_t>> planes_;
  ExactPoints points_;
  std::vector<std::int32_t> vertex_of_;
};

/// Makes one what is nearly one. Whether there is something to look at again.
bool snap(TriangleChain& chain, const std::vector<TrianglePair>& pairs, double distance) {
  return join_near_vertices(chain, pairs, distance) > 0 || merge_layers(chain, pairs, distance) ||
         snap_to_neighbours(chain, pairs, distance) > 0;
}

/// Rounds until no two triangles meet; nothing where that does not come to an end.
/// @param pairs that meet in the chain as it is given
std::optional<TriangleChain> arrange(TriangleChain chain, std::vector<TrianglePair> pairs,
                                     double snap_distance) {
  // More than that, and rounding makes more crossings than division takes away.
  std::size_t most_meeting = 1000 + 4 * pairs.size();
  for (int round = 0; round < most_rounds; ++round) {
    if (pairs.empty()) return chain;
    if (snap_distance == 0 || !snap(chain, pairs, snap_distance)) {
      most_meeting = pairs.size() / 2;
      if (!Round(chain, std::move(pairs)).divide()) return std::nullopt;
    }
    merge_equals(chain);
    auto left = meeting_pairs(chain);
    if (!left || left->size() > most_meeting) return std::nullopt;
    pairs = std::move(*left);
  }
  return std::nullopt;
}

}  // namespace

std::optional<TriangleChain> arrange_triangles(const SurfaceMesh& surface, double tolerance) {
  TriangleChain given{surface.vertices, {}};
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    given.triangles.push_back({surface.triangles[t], 1, patch_of(surface, t), false, false});
  }
  merge_equals(given);
  const auto pairs = meeting_pairs(given);
  if (!pairs) return std::nullopt;
  constexpr double small_share = 1e-3;
  for (const double snap_distance : {0.0, small_share * tolerance, tolerance}) {
    if (auto chain = arrange(given, *pairs, snap_distance)) return chain;
  }
  return std::nullopt;
}

}  // namespace tetfarm
