#include "worker/number_task.h"

namespace tetfarm {

void number_task(TaskIo&) {}

}  // namespace tetfarm
