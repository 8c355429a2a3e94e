/// A ray along +x that never meets an edge or a vertex: what encloses what is counted with it.
///
/// Source: simulation of simplicity, the ray shifted by (ε, ε²) across. Signs are exact.
#pragma once

#include "mesh/geometry/triangle_intersection.h"

namespace tetfarm {

/// How the ray from p passes the triangle: +1 from behind to the front (along its normal), -1 the
/// other way, 0 not at all. @pre p is not on the triangle.
int ray_passes(const Vec3& p, const TrianglePoints& triangle);

/// Whether p is on the closed triangle. @pre the triangle has area.
bool is_on_triangle(const Vec3& p, const TrianglePoints& triangle);

}  // namespace tetfarm
