/// Fills holes of a surface.
#pragma once

#include "mesh/healing/heal_act.h"

namespace tetfarm {

/// Each hole whose border is no longer than work.largest_hole, where triangles of the least area
/// (loop_filling.h) fill it that meet nothing. They are of the patch of a triangle beside them. The
/// number filled. Cost: O(n log n), and O(k^3) for a border of k edges.
std::int64_t fill_holes(HealingWork& work);

}  // namespace tetfarm
