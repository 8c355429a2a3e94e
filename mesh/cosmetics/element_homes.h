/// Where elements belong that cosmetics made: to the section and sub-domain in whose space they
/// lie.
///
/// Source: thesis 4.3.4.1.2 leaves elements with the sub-domain that received them; not so here.
#pragma once

#include <vector>

#include "mesh/core/tet_complex.h"
#include "mesh/cosmetics/element_passing.h"

namespace tetfarm {

/// The home of each live tet of `now`, in their order: that of the tet with the same nodes before,
/// or else of the one that held its centroid.
/// @pre `now` fills the same space as `before`, its first points are the nodes of `before` (which
/// may have moved, or be in no tet any more); it has a place, dead or live, for each tet of
/// `before`; homes_before has one for each. Cost: O(n + m log m) for m tets that are not in their
/// old place.
std::vector<ElementHome> find_homes(const TetMesh& before,
                                    const std::vector<ElementHome>& homes_before,
                                    const TetComplex& now);

}  // namespace tetfarm
