/// Halves of boxes that are open on the plane y = 0.
#pragma once

#include <algorithm>

#include "tests/support/shapes.h"

namespace tetfarm {

/// A box without the triangles whose vertices all have y = 0, vertices without triangles too.
inline SurfaceMesh open_box(const Vec3& low, const Vec3& high, int n) {
  SurfaceMesh box = shapes::box(low, high, n);
  std::erase_if(box.triangles, [&](const Triangle& triangle) {
    return std::all_of(triangle.begin(), triangle.end(), [&](std::int32_t v) {
      return box.vertices[static_cast<std::size_t>(v)].y == 0;
    });
  });
  return box;
}

inline SurfaceMesh both_of(const SurfaceMesh& a, const SurfaceMesh& b) {
  SurfaceMesh both = a;
  const auto offset = static_cast<std::int32_t>(a.vertices.size());
  both.vertices.insert(both.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& [p, q, r] : b.triangles) {
    both.triangles.push_back({p + offset, q + offset, r + offset});
  }
  return both;
}

}  // namespace tetfarm
