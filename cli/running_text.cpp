#include "cli/running_text.h"

#include <cmath>

#include "cli/progress_display.h"
#include "proto/doing.h"
#include "tasks/task_place.h"

namespace tetfarm {
namespace {

constexpr int most_shown = 5;

}  // namespace

std::string running_tasks_text(const wire::JobStatus& status) {
  std::string text;
  int shown = 0;
  for (const wire::RunningTask& task : status.running()) {
    if (!task.has_doing()) continue;
    if (++shown > most_shown) break;
    text += "         task " + std::to_string(task.task()) + ", " + task.kind() +
            (task.path() == 0 ? "" : " ") + task_place(task.kind(), task.path()) + ", " +
            clock_text(task.seconds()) + ": " + doing_text(task.doing()) + "\n";
  }
  return text;
}

std::string doing_with_share(const wire::TaskLine& task) {
  const std::string text = doing_text(task.doing());
  if (text.empty() || !(task.share() > 0)) return text;
  return text + ", about " + std::to_string(std::lround(100 * task.share())) + " % of the task";
}

}  // namespace tetfarm
