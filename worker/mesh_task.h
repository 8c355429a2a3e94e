/// The task `mesh`: the volume mesh of one leaf (thesis 4.3.3).
///
/// Inputs: "job", "subdomain", "spacing". Output: "mesh". Numbers: tets, interior_nodes,
/// min_dihedral_deg.
#pragma once

#include "worker/task_io.h"

namespace tetfarm {

/// The mesh is validated before it is published. @throws OwnDefect naming the sub-domain and
/// triangles, with files to look at and to send, when its boundary was not recovered; RefusedInput
/// when two of its vertices lie in one place.
void mesh_task(TaskIo& io);

}  // namespace tetfarm
