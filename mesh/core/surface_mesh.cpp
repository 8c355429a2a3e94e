#include "mesh/core/surface_mesh.h"

namespace tetfarm {

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
