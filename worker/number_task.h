/// The task `number`: global numbers of nodes and tets (thesis 4.3.4.1.1), from the counts in the
/// table that the coordinator makes of the finished tasks.
///
/// Input: "surface"; parameter "table". Output: "numbering".
#pragma once

#include "worker/task_io.h"

namespace tetfarm {

void number_task(TaskIo& io);

}  // namespace tetfarm
