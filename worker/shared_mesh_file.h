/// Which file of the store the write and grow tasks of a job and its assemble task fill together.
#pragma once

#include <string>
#include <vector>

#include "mesh/formats/vtkhdf/shared_vtkhdf.h"
#include "mesh/job_file/job_file.h"
#include "worker/leaf_inputs.h"
#include "worker/task_io.h"

namespace tetfarm {

/// In the scratch folder of the store. Its name is that of the job and of what decides on the
/// places, so no two meshes share one; who runs without a shared store has one that nobody else
/// sees.
SharedFile shared_mesh_file(const TaskIo& io, const TaskFile& surface, const TaskFile& numbering);

/// Whether the nodes of a job have feet: where it asks for layers.
bool has_feet(const JobFile& job);

/// What the file has once, of a job whose surface has these patches and regions.
VtkhdfNames names_of_file(const JobFile& job, const std::vector<std::string>& patches,
                          const std::vector<std::string>& regions);

/// What a mesh is written by.
struct SharedMesh {
  TaskFile job;
  TaskFile surface;
  TaskFile numbering;
};

/// Writes the cells of a portion there if the job wants such a file and this task may, and tells
/// the portion where they are. It is told the same if the task may not: the same inputs give the
/// same bytes, wherever it runs. @pre `surface` and `numbering` are those of the mesh and the
/// portion.
/// @throws IoError.
void place_in_shared_file(const TaskIo& io, const SharedMesh& mesh, const SurfaceInput& surface,
                          const LeafNumbering& numbering, Portion& portion);

}  // namespace tetfarm
