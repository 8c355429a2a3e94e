/// The task `number`: global numbers of nodes and tets (thesis 4.3.4.1.1), from the counts in the
/// table that the coordinator makes of the finished tasks. After cosmetics across cuts the counts
/// of the leaves are those that the heads of their files of elements tell.
///
/// Inputs: "surface"; of a job with layers "layer_table"; of an assimilated job "dropped"; after
/// cosmetics "core:HEAP" and "elements:HEAP" of every leaf, as extracted and as its turn made them.
/// Parameters: "table"; after cosmetics "order". Output: "numbering".
#pragma once

#include "worker/task_io.h"

namespace tetfarm {

void number_task(TaskIo& io);

}  // namespace tetfarm
