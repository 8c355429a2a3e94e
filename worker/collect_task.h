/// The task `collect`, the last of an adaptation loop: the meshes and solutions of all cycles, what
/// the solver said and left, and what the cycles came to, under the names by which they are
/// delivered.
///
/// Inputs: "job", and by cycle "mesh:N", "solution:N", "log:N", "figures:N"; "kept:N". Outputs:
/// "cycle_01.mesh", "cycle_01.sol", "cycle_01.log", "cycle_01_NAME" of kept files, "cycles.csv".
/// Numbers: cycles, vertices, triangles of the last mesh. Text: digest.
#pragma once

#include "worker/task_io.h"

namespace tetfarm {

void collect_task(TaskIo& io);

}  // namespace tetfarm
