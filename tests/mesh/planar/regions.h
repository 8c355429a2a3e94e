/// Named regions, and the checks that every planar mesh of a region must pass.
#pragma once

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "mesh/planar/planar_mesh.h"
#include "mesh/planar/triangle_complex.h"

namespace tetfarm::planar_test {

/// Adds a closed loop through the points, in their order.
inline void add_loop(PlanarRegion& region, const std::vector<Vec2>& loop) {
  const auto first = static_cast<std::int32_t>(region.points.size());
  const auto n = static_cast<std::int32_t>(loop.size());
  region.points.insert(region.points.end(), loop.begin(), loop.end());
  for (std::int32_t i = 0; i < n; ++i) region.edges.push_back({first + i, first + (i + 1) % n});
}

/// Anticlockwise; each side in n equal edges.
inline std::vector<Vec2> rectangle_loop(const Vec2& low, const Vec2& high, int n) {
  std::vector<Vec2> loop;
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < n; ++i) {
      const double t = static_cast<double>(i) / n;
      const double x = low.x + t * (high.x - low.x);
      const double y = low.y + t * (high.y - low.y);
      const double back_x = high.x - t * (high.x - low.x);
      const double back_y = high.y - t * (high.y - low.y);
      loop.push_back(side == 0   ? Vec2{x, low.y}
                     : side == 1 ? Vec2{high.x, y}
                     : side == 2 ? Vec2{back_x, high.y}
                                 : Vec2{low.x, back_y});
    }
  return loop;
}

inline PlanarRegion rectangle(const Vec2& low, const Vec2& high, int n) {
  PlanarRegion region;
  add_loop(region, rectangle_loop(low, high, n));
  return region;
}

/// Anticlockwise, or clockwise for a negative radius.
inline std::vector<Vec2> circle_loop(const Vec2& centre, double radius, int n) {
  std::vector<Vec2> loop;
  for (int i = 0; i < n; ++i) {
    const double angle = (radius < 0 ? -2 : 2) * std::numbers::pi * i / n;
    loop.push_back({centre.x + std::abs(radius) * std::cos(angle),
                    centre.y + std::abs(radius) * std::sin(angle)});
  }
  return loop;
}

inline double region_area(const PlanarRegion& region) {
  const Vec2 o = region.points[0];
  double twice = 0;
  for (const auto& [a, b] : region.edges) {
    const Vec2& p = region.points[static_cast<std::size_t>(a)];
    const Vec2& q = region.points[static_cast<std::size_t>(b)];
    twice += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
  }
  return twice / 2;
}

/// Everything that must hold of a mesh of the region; one line each.
inline std::vector<std::string> whats_wrong(const PlanarRegion& region, const PlanarMesh& mesh,
                                            bool must_be_delaunay = true) {
  const TriangleComplex complex = make_triangle_complex(mesh.points, mesh.triangles);
  std::vector<std::string> wrong = validate(complex);

  for (std::size_t v = 0; v < region.points.size(); ++v)
    if (v >= mesh.points.size() || mesh.points[v] != region.points[v]) {
      wrong.push_back("boundary point " + std::to_string(v) + " moved");
      return wrong;
    }

  // The border of the mesh is the region's edges, in their direction, and nothing else.
  std::map<std::pair<std::int32_t, std::int32_t>, int> uses;
  for (const auto& [a, b] : region.edges) --uses[{a, b}];
  double area = 0;
  for (std::int32_t t = 0; t < complex.size(); ++t) {
    const Vec2& a = complex.point(complex.node(t, 0));
    const Vec2& b = complex.point(complex.node(t, 1));
    const Vec2& c = complex.point(complex.node(t, 2));
    area += ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    for (int i = 0; i < 3; ++i) {
      if (complex.neighbour(t, i) == no_edge) {
        ++uses[{complex.node(t, next(i)), complex.node(t, previous(i))}];
        continue;
      }
      const EdgeHandle other = complex.neighbour(t, i);
      const Vec2& apex = complex.point(complex.node(triangle_of(other), edge_of(other)));
      if (must_be_delaunay && incircle(a, b, c, apex) > 0)
        wrong.push_back("an edge of triangle " + std::to_string(t) + " is not Delaunay");
    }
  }
  for (const auto& [edge, count] : uses)
    if (count != 0)
      wrong.push_back("border edge " + std::to_string(edge.first) + "-" +
                      std::to_string(edge.second) + " is off by " + std::to_string(count));
  if (std::abs(area - region_area(region)) > 1e-9 * std::abs(region_area(region)))
    wrong.push_back("area " + std::to_string(area) + " is not the region's");
  for (std::size_t v = region.points.size(); v < mesh.points.size(); ++v)
    if (complex.node2triangle[v] < 0) wrong.push_back("unused node " + std::to_string(v));
  return wrong;
}

}  // namespace tetfarm::planar_test
