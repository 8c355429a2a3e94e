/// Removes triangles that are there more than once.
///
/// Source: none; what is right is what leaves each edge with an even number of triangles.
#pragma once

#include "mesh/healing/heal_act.h"

namespace tetfarm {

/// Of triangles with the same three vertices one stays, or none where the others on their edges,
/// each counted once, are closed without it: a fold that lies on itself. The number of triangles
/// that went.
/// Cost: O(n log n).
std::int64_t remove_equal_triangles(HealingWork& work);

}  // namespace tetfarm
