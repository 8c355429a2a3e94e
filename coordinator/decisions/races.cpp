#include "coordinator/decisions/races.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr std::int64_t look_every_ms = 100;

}  // namespace

void Races::begin(TaskId task, AttemptId rival) {
  const bool is_new = rivals_.emplace(task, rival).second;
  TF_CHECK(is_new);
}

std::optional<AttemptId> Races::leave(TaskId task, AttemptId ended, AttemptId first) {
  const auto race = rivals_.extract(task);
  if (race.empty() || ended != first) return std::nullopt;
  return race.mapped();
}

std::vector<TaskId> Races::late_tasks(const std::map<AttemptId, AttemptRow>& running,
                                      const OverTime& over_ms, std::int64_t now_ms) {
  if (now_ms < next_look_ms_) return {};
  next_look_ms_ = now_ms + look_every_ms;
  std::vector<std::pair<std::int64_t, TaskId>> late;
  for (const auto& [id, attempt] : running) {
    if (attempt.is_rival || is_raced(attempt.task)) continue;
    const std::int64_t over = over_ms(attempt).value_or(0);
    if (over > 0) late.emplace_back(-over, attempt.task);
  }
  std::sort(late.begin(), late.end());
  std::vector<TaskId> tasks;
  for (const auto& [over, task] : late) tasks.push_back(task);
  return tasks;
}

std::vector<std::string> Races::validate(const std::map<AttemptId, AttemptRow>& running,
                                         const std::map<TaskId, TaskRow>& tasks) const {
  std::vector<std::string> broken;
  for (const auto& [task, rival] : rivals_) {
    const std::string name = "task " + std::to_string(task.value);
    const auto attempt = running.find(rival);
    if (attempt == running.end()) {
      broken.push_back(name + " is raced by nobody");
      continue;
    }
    if (attempt->second.task != task || !attempt->second.is_rival) {
      broken.push_back(name + " is raced by an attempt that is no rival of its");
    }
    const auto row = tasks.find(task);
    if (row != tasks.end() && row->second.attempt == rival) {
      broken.push_back(name + " is raced by its own attempt");
    }
  }
  for (const auto& [id, attempt] : running) {
    const auto race = rivals_.find(attempt.task);
    if (!attempt.is_rival || (race != rivals_.end() && race->second == id)) continue;
    broken.push_back("attempt " + std::to_string(id.value) + " races nobody");
  }
  return broken;
}

}  // namespace tetfarm
