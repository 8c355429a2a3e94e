/// The distance from a point to a triangle.
#pragma once

#include "mesh/core/vec3.h"

namespace tetfarm {

/// Square of the distance from p to the triangle abc, to rounding; abc may be degenerate. Cost:
/// some 100 flops.
double distance2_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// Whether p is nearer to the triangle than `distance`, to rounding. Cheap for most that are not.
bool is_nearer_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c,
                           double distance);

}  // namespace tetfarm
