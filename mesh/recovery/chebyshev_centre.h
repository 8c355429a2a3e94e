/// The point that lies deepest behind all of a set of planes: a linear program in four unknowns.
///
/// Source: R. Seidel, "Small-dimensional linear programming and convex hulls made easy" (1991).
/// Deterministic: the order is by a fixed seed. Cost: O(planes) expected.
#pragma once

#include <vector>

#include "mesh/geometry/fine_point.h"

namespace tetfarm {

/// Half of space: the points x with dot(normal, x) + offset >= 0.
struct HalfSpace {
  FineVec3 normal;  // unit, up to rounding
  DoubleDouble offset;
};

/// Maximises the smallest of dot(normal, x) + offset, |x| at most `reach` along each axis, up to
/// rounding. That smallest one is negative when no point lies behind all planes.
Vec3 chebyshev_centre(const std::vector<HalfSpace>& planes, double reach);

/// The same in numbers of 106 bits, for where planes are as good as parallel: ten times the cost.
FineVec3 fine_chebyshev_centre(const std::vector<HalfSpace>& planes, double reach);

}  // namespace tetfarm
