/// The task `assemble`: the global mesh in the formats that the job asks for (thesis 4.3.4.2.2).
///
/// Inputs: "job", "surface", "numbering", and of every leaf "portion:HEAP" and "tets:HEAP", which
/// are not read where its cells are in the file already. Outputs: the job's files. Numbers:
/// elements, of a mesh with layers also tets, pyramids, prisms and, where there are some, quads of
/// the boundary, nodes, boundary_triangles, subdomains, min_dihedral_deg, max_dihedral_deg,
/// mean_radius_ratio, volume, min_dihedral_gate_deg, where the smallest angle is (worst_x, y, z),
/// forced_dihedral_deg and where (forced_x, y, z), min_unforced_dihedral_gate_deg, the surface's
/// small angles (surface_triangles, surface_smallest_angle_deg, surface_triangles_below_1_deg,
/// …_below_5_deg, surface_worst_1_triangle, …_angle_deg, …_x, y, z); texts: digest,
/// surface_worst_1_patch.
#pragma once

#include "worker/task_io.h"

namespace tetfarm {

/// One sub-domain is in memory at a time, and, of a mesh with layers in VTKHDF, the feet of the
/// nodes on the wall and on the top (mesh/assemble/shared_feet.h): chunks of layers are read first
/// for them. @throws UsageError for a format that is not known.
void assemble_task(TaskIo& io);

}  // namespace tetfarm
