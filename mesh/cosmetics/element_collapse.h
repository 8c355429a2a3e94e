/// Collapses elements: an inner node slides along an edge onto its neighbour, and the tets round
/// the edge are gone.
///
/// Source: thesis 4.3.4.1, figure 78.
#pragma once

#include <optional>

#include "mesh/cosmetics/cavity.h"

namespace tetfarm::cosmetics {

/// What becomes of the ball of `node` when it slides onto `onto`; nothing when the worst tet does
/// not get better than both the present worst and `beat`.
/// @pre node is an inner node, `onto` one of its neighbours, `ball` the ball of `node`.
/// Cost: at most one quality a tet of the ball.
std::optional<Replacement> find_collapse(const WorkMesh& work,
                                         const std::vector<std::int32_t>& ball, std::int32_t node,
                                         std::int32_t onto, double beat);

}  // namespace tetfarm::cosmetics
