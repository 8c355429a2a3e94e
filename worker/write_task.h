/// The task that gives a leaf's elements their global numbers and brings them into the form in
/// which they are assembled.
///
/// Inputs: job, surface, numbering, and the leaf as it was meshed ("subdomain", "mesh"); after
/// cosmetics across cuts also "core:HEAP" and the "elements:HEAP" of it and its neighbours.
/// Parameters: after cosmetics "colours", the lines of the order that are of the leaf and its
/// neighbours. Outputs: "portion" and "tets". Numbers: tets, unforced_elements,
/// unforced_min_dihedral_deg, unforced_worst_x, y, z (mesh/assemble/forced_nodes.h). On the way it
/// writes the leaf's cells into the mesh file that all leaves fill together, where the worker sees
/// the store. All this was in assembling once, which runs alone; it can be done leaf by leaf
/// (docs/decisions/0008).
#pragma once

#include "worker/task_io.h"

namespace tetfarm {

void write_task(TaskIo& io);

}  // namespace tetfarm
