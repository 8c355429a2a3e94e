#include "coordinator/decisions/retry_delays.h"

#include <algorithm>

namespace tetfarm {

std::int64_t delay_after(std::uint32_t count, std::int64_t first_ms, std::int64_t longest_ms) {
  std::int64_t delay = first_ms;
  for (std::uint32_t i = 1; i < count && delay < longest_ms; ++i) delay *= 2;
  return std::min(delay, longest_ms);
}

void RetryDelays::failed_on(TaskId task, WorkerId worker, std::int64_t now_ms) {
  delays_[task] = {now_ms, worker};
}

void RetryDelays::wait_until(TaskId task, std::int64_t until_ms) {
  delays_[task].until_ms = until_ms;
}

void RetryDelays::forget(TaskId task) { delays_.erase(task); }

std::int64_t RetryDelays::wait_ms(TaskId task, std::int64_t now_ms) const {
  const auto delay = delays_.find(task);
  return delay == delays_.end() ? 0 : std::max<std::int64_t>(delay->second.until_ms - now_ms, 0);
}

bool RetryDelays::prefers_other(TaskId task, WorkerId worker, std::int64_t now_ms) const {
  const auto delay = delays_.find(task);
  return delay != delays_.end() && delay->second.failed_on == worker &&
         now_ms < delay->second.until_ms + elsewhere_ms_;
}

std::vector<std::string> RetryDelays::validate(const std::map<TaskId, TaskRow>& tasks) const {
  std::vector<std::string> broken;
  for (const auto& [task, delay] : delays_) {
    if (tasks.contains(task)) continue;
    broken.push_back("task " + std::to_string(task.value) + " waits and is not at hand");
  }
  return broken;
}

}  // namespace tetfarm
