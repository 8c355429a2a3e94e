/// The mesh of a leaf when all turns of cosmetics are over: its core, and what it has of the
/// sections that it shares, each from the file of the last turn.
#pragma once

#include "mesh/assemble/global_mesh.h"
#include "tasks/write_contract.h"
#include "worker/element_input.h"

namespace tetfarm {

/// Reads the sub-domain and its mesh, what its core leaves of them, and the sections that it shares
/// in the elements of it and its neighbours. @throws DamagedInput.
MeshPart part_after_cosmetics(const TaskIo& io, const WriteGiven& given, TreePath leaf,
                              const Colours& colours);

}  // namespace tetfarm
