/// The longest axis of a box, and how far it is from a point: what trees of boxes are built and
/// searched by.
#pragma once

#include <algorithm>

#include "mesh/core/vec3.h"

namespace tetfarm {

/// Of axes equally long the first.
inline int longest_axis(const Box3& box) {
  const Vec3 size = box.size();
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

/// Square of the distance from p to the box; 0 of a point in it.
inline double distance2_to_box(const Box3& box, const Vec3& p) {
  const double x = std::max(0.0, std::max(box.low.x - p.x, p.x - box.high.x));
  const double y = std::max(0.0, std::max(box.low.y - p.y, p.y - box.high.y));
  const double z = std::max(0.0, std::max(box.low.z - p.z, p.z - box.high.z));
  return x * x + y * y + z * z;
}

}  // namespace tetfarm
