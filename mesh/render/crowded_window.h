/// The part of the plane in which most of a mesh's nodes are: round the airfoil of a flow whose
/// outer boundary is far away.
///
/// It is as large as the middle three fifths of the nodes in x and in y and a little more; where
/// that is most of the mesh anyway, all is shown. Cost: O(n).
#pragma once

#include <span>

#include "mesh/render/plane_frame.h"

namespace tetfarm {

/// @param shape width over height of what is drawn. @pre there is a point, all are finite.
PlaneWindow crowded_window(std::span<const Vec2> points, double shape);

}  // namespace tetfarm
