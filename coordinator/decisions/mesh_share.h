/// How much of the meshing of a leaf is done, by the stage that it is in.
///
/// Source: none in the thesis. What the stages take is a sum as in store/task_time.h: recovery goes
/// by the needles of the surface, everything else by the elements; how the time of the elements
/// spreads over the stages was measured: docs/measurements/2026-11-plan_accuracy.md, "While a leaf
/// is meshed".
#pragma once

#include "base/work_stage.h"

namespace tetfarm {

/// 0 to 1. `elements` are those expected of the leaf, `needles` the triangles with a small angle of
/// its surface. 0 for stages that meshing does not have. Cost: O(1).
double mesh_share(const WorkCount& count, double elements, double needles);

}  // namespace tetfarm
