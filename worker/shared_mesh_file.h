/// Which file of the store the write tasks of a job and its assemble task fill together.
#pragma once

#include "mesh/formats/vtkhdf/shared_vtkhdf.h"
#include "worker/task_io.h"

namespace tetfarm {

/// In the scratch folder of the store. Its name is that of the job and of what decides on the
/// places, so no two meshes share one; who runs without a shared store has one that nobody else
/// sees.
SharedFile shared_mesh_file(const TaskIo& io, const TaskFile& surface, const TaskFile& numbering);

}  // namespace tetfarm
