/// How well shaped the prisms of layers are.
///
/// Source: the scaled Jacobian of Knupp, "Algebraic mesh quality metrics", SIAM J. Sci. Comput. 23
/// (2001), of which a prism has one at each corner. A prism on a slender triangle cannot have more
/// than that triangle lets a straight one have: so it is told as a share of this.
#pragma once

#include <array>
#include <vector>

#include "mesh/core/vec3.h"
#include "mesh/layers/layer_growth.h"

namespace tetfarm {

/// The scaled Jacobian of a straight prism on the first three corners of this one.
double jacobian_of_straight(const std::array<Vec3, 6>& prism);

/// Of each prism of boundary layers the scaled Jacobian over what a straight prism has on the
/// triangle at the foot of its column; in the order of the prisms, absorbing ones left out.
/// Cost: O(prisms).
std::vector<double> jacobian_shares(const GrownLayers& layers);

}  // namespace tetfarm
