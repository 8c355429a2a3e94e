#include "mesh/core/surface_mesh.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {

std::int64_t meshed_sides(const SurfaceMesh& surface) {
  std::int64_t count = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) count += meshed_sides(surface, t);
  return count;
}

std::int32_t region_count(const SurfaceMesh& surface) {
  std::int32_t last = 1;
  for (const auto& [behind, front] : surface.sides) last = std::max({last, behind, front});
  return last;
}

double domain_volume(const SurfaceMesh& surface) {
  TF_CHECK(surface.sides.empty() || surface.sides.size() == surface.triangles.size());
  std::vector<Triangle> boundary;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    const auto [behind, front] = sides_of(surface, t);
    if (behind > 0 && front == 0) boundary.push_back({a, b, c});
    if (behind == 0 && front > 0) boundary.push_back({a, c, b});
  }
  return enclosed_volume(surface.vertices, boundary);
}

double enclosed_volume(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles) {
  const Vec3 origin = vertices.empty() ? Vec3{} : bounding_box(vertices).centre();
  double sum = 0;
  for (const Triangle& t : triangles) {
    const Vec3 a = vertices[static_cast<std::size_t>(t[0])] - origin;
    const Vec3 b = vertices[static_cast<std::size_t>(t[1])] - origin;
    const Vec3 c = vertices[static_cast<std::size_t>(t[2])] - origin;
    sum += dot(a, cross(b, c));
  }
  return sum / 6.0;
}

Box3 bounding_box(const std::vector<Vec3>& points) {
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  return box;
}

}  // namespace tetfarm
