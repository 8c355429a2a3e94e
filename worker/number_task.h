#pragma once

#include "worker/task_io.h"

namespace tetfarm {

void number_task(TaskIo& io);

}  // namespace tetfarm
