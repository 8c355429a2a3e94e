/// A point from which every face of a cavity is strictly visible, as far from all of them as can be
/// found.
///
/// Source: P. L. George, H. Borouchaki, E. Saltel, "'Ultimate' robustness in meshing an arbitrary
/// polyhedron" (2003), section 4; the place is a linear program (chebyshev_centre.h).
/// Deterministic. Cost: O(faces).
#pragma once

#include <array>
#include <optional>
#include <span>

#include "mesh/geometry/fine_point.h"

namespace tetfarm {

/// Three corners; visible points are on the side from which they turn anticlockwise.
using VisibleFace = std::array<FinePoint, 3>;

/// Nothing when no point with exactly positive orient3d to every face was found near `start`. What
/// room there is may be as thin as the last of a fine point's bits.
std::optional<FinePoint> kernel_point(std::span<const VisibleFace> faces, const FinePoint& start);

/// The distance from x to the nearest of the faces' planes; negative behind one.
double room_at(std::span<const VisibleFace> faces, const FinePoint& x);

/// Whether orient3d to every face is exactly positive.
bool sees_all(std::span<const VisibleFace> faces, const FinePoint& x);

}  // namespace tetfarm
