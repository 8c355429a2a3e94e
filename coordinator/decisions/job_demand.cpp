/// JobState, the part about what waits for workers: what a pool of workers is sized by.
#include <algorithm>

#include "coordinator/decisions/job_state.h"

namespace tetfarm {

/// How many tasks will be ready at once when this one is done, beside the first, which its own
/// worker can take: the second half of a cut; all leaves of an order.
std::uint64_t JobState::tasks_brought_by(const TaskRow& running) const {
  if (running.kind == TaskKind::decompose) {
    const auto node = durable_.subdomains.find({running.job, running.path});
    return node != durable_.subdomains.end() && node->second.parts > 1 ? 1 : 0;
  }
  if (running.kind != TaskKind::order) return 0;
  std::uint64_t leaves = 0;
  for (auto node = durable_.subdomains.lower_bound({running.job, 0});
       node != durable_.subdomains.end() && node->first.first == running.job; ++node) {
    if (node->second.state == SubdomainState::leaf) ++leaves;
  }
  return leaves > 0 ? leaves - 1 : 0;
}

std::vector<TaskId> JobState::running_and_next(std::size_t count) const {
  std::vector<TaskId> tasks;
  for (const auto& [id, attempt] : durable_.running_attempts) {
    if (!attempt.is_rival) tasks.push_back(attempt.task);
  }
  FairTurns turns(lists_.offers_of_users(), users_at_work());
  for (; count > 0; --count) {
    const std::optional<TaskId> turn = turns.next();
    if (!turn) break;
    tasks.push_back(*turn);
  }
  return tasks;
}

std::map<std::uint64_t, std::uint64_t> JobState::demand(bool of_solvers) const {
  std::map<std::uint64_t, std::uint64_t> tasks;
  const auto wanted = [this](const TaskRow& task) {
    return std::max(task.memory_bytes, expectation_.bytes(task.kind));
  };
  for (const auto& [priority, rank, id] : lists_.offers()) {
    const TaskRow& task = durable_.tasks.at(id);
    if (traits_of(task.kind).is_of_others == of_solvers) ++tasks[wanted(task)];
  }
  if (of_solvers) return tasks;  // none comes beside the one whose worker can take it
  for (const auto& [id, attempt] : durable_.running_attempts) {
    const TaskRow& running = durable_.tasks.at(attempt.task);
    const std::uint64_t brought = attempt.is_rival ? 0 : tasks_brought_by(running);
    if (brought > 0) tasks[wanted(running)] += brought;
  }
  return tasks;
}

}  // namespace tetfarm
