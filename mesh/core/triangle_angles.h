/// The smallest angle of a triangle: what makes needles and caps of the triangles of a surface.
///
/// Units: degrees.
#pragma once

#include <cstdint>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// A triangle with a smaller angle is called a needle: where there are many, recovering them takes
/// most of the time of a mesh (docs/measurements/2026-11-plan_accuracy.md).
inline constexpr double needle_deg = 15;

/// Right also where the cosine rounds to 1. 0 of a triangle without area.
double smallest_angle_deg(const Vec3& a, const Vec3& b, const Vec3& c);

/// How many of the triangles are needles. @pre their nodes are vertices. Cost: O(n).
std::int64_t needle_count(const std::vector<Vec3>& vertices,
                          const std::vector<Triangle>& triangles);

}  // namespace tetfarm
