/// The task `assemble`: the global mesh in the formats that the job asks for (thesis 4.3.4.2.2).
///
/// Inputs: "job", "surface", "numbering", and of every leaf "portion:HEAP" and "tets:HEAP", which
/// are not read where its cells are in the file already. Outputs: the job's files. Numbers:
/// elements, nodes, boundary_triangles, subdomains, min_dihedral_deg, max_dihedral_deg,
/// mean_radius_ratio, volume, min_dihedral_gate_deg, where the smallest angle is (worst_x, y, z),
/// forced_dihedral_deg and where (forced_x, y, z); text: digest.
#pragma once

#include "worker/task_io.h"

namespace tetfarm {

/// One sub-domain is in memory at a time. @throws UsageError for a format that is not known.
void assemble_task(TaskIo& io);

}  // namespace tetfarm
