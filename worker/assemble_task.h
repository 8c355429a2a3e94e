#pragma once

#include "worker/task_io.h"

namespace tetfarm {

void assemble_task(TaskIo& io);

}  // namespace tetfarm
