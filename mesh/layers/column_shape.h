/// Up to which layer the prisms of a plan keep their shape, before there are any.
///
/// Source: the measure is that of layer_shape.h. Columns narrow in concave corners, and twist where
/// lines grow unlike their neighbours: then the upper prisms are worse than the first.
#pragma once

#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/layers/layer_plan.h"

namespace tetfarm {

/// Of each line the layers below the first prism at it whose scaled Jacobian is less than `least`
/// times that of a straight prism on the foot of its column; all it has where there is none, and
/// where the lowest prism of the column is such a one. Cost: O(cells).
std::vector<int> well_shaped_layers(const LayerPlan& plan, const SurfaceMesh& surface,
                                    double least);

}  // namespace tetfarm
