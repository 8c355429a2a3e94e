/// Where a NACA profile lies whose nodes are given: nose, chord, direction, and which of the two
/// trailing edges.
///
/// Source: least squares of the distances from the profile, by Gauss and Newton from the two nodes
/// that are farthest apart, the nose at the one or the other. Round numbers are taken in place of
/// those of the fit where the nodes cannot tell them apart. Cost: at most 400 nodes are fitted, 4
/// times 20 steps of O(1024) each.
#pragma once

#include <optional>
#include <span>

#include "mesh/adaptation/naca_profile.h"

namespace tetfarm {

/// The profile of the thickness that is nearest to the nodes; nothing where they are fewer than
/// five, or nothing fits at all. Whether they lie on it is for nodes_on_curves.h to say.
std::optional<NacaPlace> fitted_naca(std::span<const Vec2> nodes, double thickness);

/// The same where all but the trailing edge is known.
NacaPlace with_fitting_edge(std::span<const Vec2> nodes, NacaPlace place);

}  // namespace tetfarm
