/// The task `adapt`: the mesh of the next cycle of an adaptation loop, adapted to the solution of
/// the cycle before, and that solution on the new mesh (thesis 3.3.1 and 3.3.3).
///
/// Inputs: "job", "mesh", "solution", "spline:N" of the files that the job's curves name. Outputs:
/// "mesh", "start", "figures" (cycle_figures.h). Numbers: vertices, triangles, unit_edges_percent,
/// quality_min.
#pragma once

#include "worker/task_io.h"

namespace tetfarm {

void adapt_task(TaskIo& io);

}  // namespace tetfarm
