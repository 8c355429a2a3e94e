#include "worker/assemble_task.h"

namespace tetfarm {

void assemble_task(TaskIo&) {}

}  // namespace tetfarm
