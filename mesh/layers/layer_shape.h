/// How well shaped the prisms of layers are.
///
/// Source: the scaled Jacobian of Knupp, "Algebraic mesh quality metrics", SIAM J. Sci. Comput. 23
/// (2001), of which a prism has one at each corner. A prism on a slender triangle cannot have more
/// than that triangle lets a straight one have: so it is told as a share of this.
#pragma once

#include <optional>

#include "mesh/layers/layer_growth.h"

namespace tetfarm {

/// The least of all prisms of boundary layers, each over what a straight prism has on the triangle
/// at the foot of its column; nothing where there are none. Cost: O(prisms).
std::optional<double> least_jacobian_share(const GrownLayers& layers);

}  // namespace tetfarm
