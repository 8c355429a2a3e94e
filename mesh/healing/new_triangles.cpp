#include "mesh/healing/new_triangles.h"

#include "mesh/geometry/triangle_intersection.h"

namespace tetfarm {

NearTriangles::NearTriangles(const SurfaceMesh& surface)
    : vertices_(surface.vertices),
      triangles_(surface.triangles),
      tree_(triangle_boxes(surface.vertices, surface.triangles)) {}

bool NearTriangles::meet(std::span<const Triangle> made, const std::vector<char>& is_gone) const {
  for (std::size_t i = 0; i < made.size(); ++i) {
    for (std::size_t j = i + 1; j < made.size(); ++j) {
      if (triangles_meet_beyond_shared(vertices_, made[i], made[j])) return true;
    }
    Box3 box;
    for (const std::int32_t v : made[i]) box.add(vertices_[static_cast<std::size_t>(v)]);
    const bool meets = tree_.any(box, [&](std::int32_t n) {
      const auto other = static_cast<std::size_t>(n);
      if (!is_gone.empty() && is_gone[other] != 0) return false;
      if (is_degenerate(triangle_points(vertices_, triangles_[other]))) return false;
      return triangles_meet_beyond_shared(vertices_, made[i], triangles_[other]);
    });
    if (meets) return true;
  }
  return false;
}

}  // namespace tetfarm
