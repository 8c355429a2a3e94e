/// The task `order`: who shares nodes with whom, and the colours by which the leaves have their
/// turn in cosmetics across cuts (thesis 4.3.4.1, figs. 81 to 83). It needs the boundaries of all
/// leaves, one after the other, but no mesh: it runs while the leaves are meshed.
///
/// Inputs: "subdomain:HEAP" of every leaf. Outputs: "shared:HEAP" for every leaf. Text: order, a
/// line "HEAP COLOUR NEIGHBOUR NEIGHBOUR …" for each leaf. Number: colours.
#pragma once

#include "worker/task_io.h"

namespace tetfarm {

void order_task(TaskIo& io);

}  // namespace tetfarm
