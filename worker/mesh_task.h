/// The task `mesh`: the volume mesh of one leaf (thesis 4.3.3).
///
/// Inputs: "job", "subdomain", "spacing". Output: "mesh". Numbers: tets, interior_nodes,
/// min_dihedral_deg.
#pragma once

#include "worker/task_io.h"

namespace tetfarm {

/// The mesh is validated before it is published. @throws RefusedInput naming the sub-domain and
/// input triangles, with a .vtp file, when the leaf cannot be meshed.
void mesh_task(TaskIo& io);

}  // namespace tetfarm
