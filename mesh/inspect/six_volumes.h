/// The volume between a triangle and a point.
#pragma once

#include <array>

#include "mesh/geometry/triangle_intersection.h"

namespace tetfarm {

/// Six times it, positive when the point is behind the triangle: long, as the sign of sums of it
/// decides what is out.
inline long double six_volumes(const TrianglePoints& t, const Vec3& origin) {
  const auto from = [&origin](const Vec3& p) {
    return std::array<long double, 3>{static_cast<long double>(p.x) - origin.x,
                                      static_cast<long double>(p.y) - origin.y,
                                      static_cast<long double>(p.z) - origin.z};
  };
  const auto [ax, ay, az] = from(t[0]);
  const auto [bx, by, bz] = from(t[1]);
  const auto [cx, cy, cz] = from(t[2]);
  return ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
}

}  // namespace tetfarm
