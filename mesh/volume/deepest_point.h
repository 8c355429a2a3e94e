/// The point that lies deepest behind all of a set of planes: a linear program in four unknowns.
///
/// Source: R. Seidel, "Small-dimensional linear programming and convex hulls made easy" (1991).
/// Deterministic: the order is by a fixed seed. Cost: O(planes) expected.
#pragma once

#include <vector>

#include "mesh/core/vec3.h"

namespace tetfarm {

/// Half of space: the points x with dot(normal, x) + offset >= 0.
struct HalfSpace {
  Vec3 normal;  // unit
  double offset;
};

/// Maximises the smallest of dot(normal, x) + offset, |x| at most `reach` along each axis, up to
/// rounding. That smallest one is negative when no point lies behind all planes.
Vec3 deepest_point(std::vector<HalfSpace> planes, double reach);

}  // namespace tetfarm
