/// The task `extract`: the elements of a leaf that cosmetics across cuts may work on, in sections
/// by who shares them (thesis 4.3.4.1.2), so that whoever needs the elements at one cut need not
/// read the others.
///
/// Inputs: "subdomain", "mesh", "shared". Output: "elements". Numbers: tets, core_tets.
#pragma once

#include "worker/task_io.h"

namespace tetfarm {

void extract_task(TaskIo& io);

}  // namespace tetfarm
