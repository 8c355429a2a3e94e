/// Replaces triangles that are in each other's way.
///
/// Source: M. Attene, "A lightweight approach to repairing digitized polygon meshes" (2010): the
/// triangles round a crossing go, and the hole is filled; where that crosses again, more of them
/// go.
#pragma once

#include "mesh/healing/heal_act.h"

namespace tetfarm {

/// Each group of connected triangles in `is_crossing` that lies in one patch and whose
/// surroundings, up to two rings of triangles, leave one hole, where what fills it meets nothing
/// and is nowhere farther than work.largest_move from what was there, nor that from it. The number
/// of groups replaced. Cost: O(n log n) for each group.
std::int64_t replace_crossings(HealingWork& work, const std::vector<char>& is_crossing);

}  // namespace tetfarm
