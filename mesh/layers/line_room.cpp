#include "mesh/layers/line_room.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/triangle_intersection.h"

namespace tetfarm {
namespace {

/// Of the angle between a line and the normal of a triangle that it comes down on.
constexpr double facing_cosine = 0.7;

bool has_corner(const Triangle& triangle, std::int32_t vertex) {
  return triangle[0] == vertex || triangle[1] == vertex || triangle[2] == vertex;
}

/// Whether the triangle is of a plane that the line stays in.
bool is_held_by(const WallPlanes& planes, std::size_t line, std::int32_t triangle) {
  const std::int32_t plane = planes.plane_of_triangle[at(triangle)];
  return plane >= 0 && planes.hold_in(line, plane);
}

/// A line counts as one in the plane of a triangle where the sine of the angle between them is
/// less.
constexpr double in_plane_sine = 1e-6;

/// The share of the way from p to q that ends at the triangle, which it meets: at its plane, or, of
/// a line in its plane, no later than at its nearest corner.
double share_before(const Vec3& p, const Vec3& q, const TrianglePoints& t) {
  const Vec3 way = q - p;
  const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const double whole = dot(normal, way);
  if (std::abs(whole) > in_plane_sine * norm(normal) * norm(way)) {
    return std::clamp(dot(normal, t[0] - p) / whole, 0.0, 1.0);
  }
  const auto along = [&](const Vec3& corner) { return dot(corner - p, way) / norm2(way); };
  return std::clamp(std::min({along(t[0]), along(t[1]), along(t[2])}), 0.0, 1.0);
}

/// Whether the line comes down on the triangle, rather than along it.
bool faces_line(const Vec3& line, const TrianglePoints& t) {
  const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
  return std::abs(dot(normal, line)) >= facing_cosine * norm(normal) * norm(line);
}

/// What a line has of the gap between it and a triangle, those of the triangle have as well: their
/// layers are between its vertices, too, where none of them looks.
void hold_opposite(const WallGraph& graph, std::span<const Vec3> along, const Triangle& triangle,
                   double way, std::vector<double>& ways) {
  for (const std::int32_t v : triangle) {
    if (graph.vertex2line[at(v)] < 0) continue;
    for (std::size_t line = at(graph.vertex2line[at(v)]);
         line < graph.feet.size() && graph.feet[line] == v; ++line) {
      if (!(along[line] == Vec3{})) ways[line] = std::min(ways[line], way);
    }
  }
}

/// The first s > 0 at which c0 + c1 s + c2 s² is zero; HUGE_VAL when there is none.
double first_root(double c0, double c1, double c2) {
  TF_CHECK(c0 > 0);
  const double discriminant = c1 * c1 - 4 * c2 * c0;
  if (discriminant < 0) return HUGE_VAL;
  // Of c0 x² + c1 x + c2 the largest x = 1 / s, without cancellation.
  const double q = std::sqrt(discriminant);
  const double largest = c1 <= 0 ? (-c1 + q) / (2 * c0) : -2 * c2 / (c1 + q);
  return largest > 0 ? 1 / largest : HUGE_VAL;
}

/// The height up to which the prism on a triangle keeps its share of the Jacobian at each corner.
double fold_height(const TrianglePoints& p, const std::array<Vec3, 3>& along) {
  const Vec3 u = p[1] - p[0];
  const Vec3 v = p[2] - p[0];
  const Vec3 du = along[1] - along[0];
  const Vec3 dv = along[2] - along[0];
  const Vec3 area = cross(u, v);
  const Vec3 linear = cross(u, dv) + cross(du, v);
  const Vec3 square = cross(du, dv);
  double height = HUGE_VAL;
  for (const Vec3& direction : along) {
    const double at_wall = dot(area, direction);
    if (at_wall == 0) continue;
    // The wall's normals point out of the domain: its Jacobian is negative.
    const double sign = at_wall > 0 ? 1 : -1;
    height =
        std::min(height, first_root(sign * at_wall * (1 - least_jacobian),
                                    sign * dot(linear, direction), sign * dot(square, direction)));
  }
  return height;
}

}  // namespace

std::vector<double> free_ways(const SurfaceMesh& surface, const WallGraph& graph,
                              const WallPlanes& planes, std::span<const Vec3> along,
                              std::span<const double> wanted) {
  TF_CHECK(along.size() == graph.feet.size() && wanted.size() == graph.feet.size());
  const BoxTree tree(triangle_boxes(surface.vertices, surface.triangles));
  std::vector<double> ways(wanted.begin(), wanted.end());
  for (std::size_t i = 0; i < ways.size(); ++i) {
    if (along[i] == Vec3{}) continue;
    const std::int32_t foot = graph.feet[i];
    const Vec3 p = surface.vertices[at(foot)];
    const double reach = wanted[i] / share_of_free_way;
    const Vec3 q = p + reach * along[i];
    Box3 box;
    box.add(p);
    box.add(q);
    tree.query(box, [&](std::int32_t t) {
      const Triangle& triangle = surface.triangles[at(t)];
      if (has_corner(triangle, foot) || is_held_by(planes, i, t)) return;
      const TrianglePoints points = triangle_points(surface.vertices, triangle);
      if (!segment_meets_triangle(p, q, points)) return;
      const double way = share_of_free_way * reach * share_before(p, q, points);
      ways[i] = std::min(ways[i], way);
      if (faces_line(q - p, points)) hold_opposite(graph, along, triangle, way, ways);
    });
  }
  return ways;
}

std::vector<double> fold_heights(const SurfaceMesh& surface, const WallGraph& graph,
                                 std::span<const Vec3> along, std::span<const double> wanted) {
  TF_CHECK(along.size() == graph.feet.size() && wanted.size() == graph.feet.size());
  std::vector<double> heights(wanted.begin(), wanted.end());
  for (std::size_t i = 0; i < graph.wall.size(); ++i) {
    const Triangle& triangle = surface.triangles[at(graph.wall[i])];
    const Triangle& lines = graph.wall_lines[i];
    std::array<Vec3, 3> directions;
    bool all_move = true;
    for (std::size_t k = 0; k < 3; ++k) {
      directions[k] = along[at(lines[k])];
      all_move = all_move && !(directions[k] == Vec3{});
    }
    if (!all_move) continue;
    const double height = fold_height(triangle_points(surface.vertices, triangle), directions);
    for (const std::int32_t line : lines) heights[at(line)] = std::min(heights[at(line)], height);
  }
  return heights;
}

}  // namespace tetfarm
