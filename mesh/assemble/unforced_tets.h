/// The tets of a sub-domain that are as good as the mesher makes them: none of their nodes is one
/// where the surface itself forces small angles (forced_nodes.h). Units: degrees.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/assemble/portion.h"

namespace tetfarm {

struct UnforcedTets {
  std::int64_t tets = 0;
  double min_dihedral_deg = 180;
  Vec3 worst_centroid;  ///< of the first with the smallest angle
};

/// `is_forced` tells of the first nodes of the portion; behind them none is forced.
/// @pre the portion has its tets. Cost: O(nodes), and O(tets) where a node is forced.
UnforcedTets unforced_tets(const Portion& portion, const std::vector<bool>& is_forced);

}  // namespace tetfarm
