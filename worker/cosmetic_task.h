/// The task `cosmetic`: the turn of one leaf in cosmetics across cuts (thesis 4.3.4.1).
///
/// Inputs: "spacing"; "own", the elements of the leaf as they were extracted; for each neighbour
/// "waits:HEAP", its elements as extracted, or "had_turn:HEAP", those that its turn made. Of each
/// file only the head and the sections that the leaf shares are read. Parameter: colours, a line
/// "HEAP COLOUR" for the leaf and each neighbour. Output: "elements", every section that the leaf
/// shares. Numbers: tets, swaps, moves, collapses, splits, min_dihedral_deg, bytes_read,
/// bytes_of_files.
#pragma once

#include "worker/task_io.h"

namespace tetfarm {

void cosmetic_task(TaskIo& io);

}  // namespace tetfarm
