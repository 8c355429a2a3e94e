/// The volume of a tet with its sign, exactly enough to tell a flat or turned tet from a good one.
#pragma once

#include "mesh/core/vec3.h"

namespace tetfarm {

/// As tet_volume, with the digits of long double: sums of many stay right to 1e-9 and better.
long double signed_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Positive as computed in long double, or else in 113 bits.
bool has_positive_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace tetfarm
