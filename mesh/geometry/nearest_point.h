/// The point of a segment or of a triangle that is nearest to a given one.
///
/// To rounding; a segment or triangle may be degenerate.
#pragma once

#include "mesh/core/vec3.h"

namespace tetfarm {

Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b);

/// Cost: some 80 flops.
Vec3 nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace tetfarm
