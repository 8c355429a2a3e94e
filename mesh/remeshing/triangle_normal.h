/// The area and the normal of a triangle, as far as its corners tell them.
#pragma once

#include <algorithm>

#include "mesh/geometry/triangle_intersection.h"

namespace tetfarm {

/// Along the normal, as long as twice the area.
inline Vec3 doubled_area(const TrianglePoints& c) { return cross(c[1] - c[0], c[2] - c[0]); }

/// The normal, of length 1; zero where the triangle is lower than `least_height_share` of its
/// longest edge: the normal of a needle is that of the rounding of its corners.
inline Vec3 sure_normal(const TrianglePoints& c, double least_height_share) {
  const Vec3 doubled = doubled_area(c);
  const double longest2 = std::max({norm2(c[1] - c[0]), norm2(c[2] - c[1]), norm2(c[0] - c[2])});
  if (norm2(doubled) < least_height_share * least_height_share * longest2 * longest2) return {};
  return normalized(doubled);
}

}  // namespace tetfarm
