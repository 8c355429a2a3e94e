/// Points spread over a triangle, and over all of a surface.
#pragma once

#include <algorithm>

#include "mesh/core/surface_mesh.h"
#include "mesh/geometry/triangle_intersection.h"
#include "mesh/remeshing/triangle_normal.h"

namespace tetfarm {

/// How far apart so many points of the surface are. Cost: O(n).
double sample_step(const SurfaceMesh& surface, double points);

/// Calls visit(point) for points of the triangle about `step` apart, one at least and no more than
/// 1000 in a row: rows along its longest edge, so that a needle has no more of them than its area
/// asks for. @pre the triangle has area. Cost: O(points).
template <typename Visitor>
void sample_triangle(const TrianglePoints& c, double step, Visitor&& visit) {
  constexpr double most_in_a_row = 1000;
  const double longest =
      std::max({distance(c[0], c[1]), distance(c[1], c[2]), distance(c[2], c[0])});
  const double height = norm(doubled_area(c)) / longest;
  const int along = std::max(1, static_cast<int>(std::min(longest / step, most_in_a_row)));
  const int across = std::max(1, static_cast<int>(std::min(height / step, most_in_a_row)));
  std::size_t k = 0;
  while (k < 2 && distance(c[k], c[(k + 1) % 3]) < longest) ++k;
  const Vec3& a = c[k];
  const Vec3& b = c[(k + 1) % 3];
  const Vec3& apex = c[(k + 2) % 3];
  for (int i = 0; i < across; ++i) {
    const double up = (i + 1.0 / 3) / across;
    for (int j = 0; j < along; ++j) {
      const double at = (j + 0.5) / along;
      visit((1 - up) * ((1 - at) * a + at * b) + up * apex);
    }
  }
}

}  // namespace tetfarm
