/// A point from which every face of a cavity is strictly visible, as far from all of them as can be
/// found.
///
/// Source: P. L. George, H. Borouchaki, E. Saltel, "'Ultimate' robustness in meshing an arbitrary
/// polyhedron" (2003), section 4; the place is a linear program (deepest_point.h). Deterministic.
/// Cost: O(faces).
#pragma once

#include <array>
#include <optional>
#include <span>

#include "mesh/core/vec3.h"

namespace tetfarm {

/// Three corners; visible points are on the side from which they turn anticlockwise.
using VisibleFace = std::array<Vec3, 3>;

/// Nothing when no point with exactly positive orient3d to every face was found near `start`.
std::optional<Vec3> kernel_point(std::span<const VisibleFace> faces, const Vec3& start);

}  // namespace tetfarm
