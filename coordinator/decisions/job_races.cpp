/// JobState, the part about time and room: which task a worker has time and memory for, when a
/// running one is late, and second attempts that race late ones.
#include <algorithm>
#include <optional>

#include "coordinator/decisions/job_state.h"

namespace tetfarm {

/// How long an attempt may run before its worker ends it.
std::int64_t JobState::limit_ms(const TaskRow& task) const {
  if (traits_of(task.kind).is_of_others) return rules_.foreign_limit_ms;
  const std::optional<double> seconds = expectation_.seconds(task);
  if (!seconds) return rules_.unknown_limit_ms;
  const auto expected_ms = static_cast<std::int64_t>(*seconds * 1000);
  return std::max(rules_.least_limit_ms, rules_.limit_factor * expected_ms);
}

/// The room that a task is given: what it asked for after it was out of memory, or what its kind
/// took before; never more than the largest worker has or can have, so that there will be one to
/// try it on.
std::uint64_t JobState::memory_for(const TaskRow& task) const {
  return std::min(std::max(task.memory_bytes, expectation_.bytes(task.kind)),
                  workers_.largest_memory());
}

bool JobState::has_time_for(const WorkerSession& session, const TaskRow& task, Moment now) const {
  if (session.terms.ends_ms == 0) return true;
  const std::optional<double> seconds = expectation_.seconds(task);
  return !seconds || *seconds * 1000 <= static_cast<double>(session.terms.ends_ms - now.steady_ms);
}

/// Tasks that run much longer than expected and that nobody races yet, the latest first.
std::vector<TaskId> JobState::late_tasks(Moment now) {
  const auto over_ms = [&](const AttemptRow& attempt) -> std::optional<std::int64_t> {
    const std::optional<double> seconds = expectation_.seconds(durable_.tasks.at(attempt.task));
    if (!seconds) return std::nullopt;
    const std::int64_t bound_ms = std::max(
        rules_.least_late_ms, rules_.late_factor * static_cast<std::int64_t>(*seconds * 1000));
    return now.steady_ms - leases_.started_ms(attempt.id) - bound_ms;
  };
  return races_.late_tasks(durable_.running_attempts, over_ms, now.steady_ms);
}

/// A late task for a worker that has nothing else to do; 0 when there is none for it.
TaskId JobState::pick_late(WorkerId worker, std::vector<TaskId>& late,
                           const WorkerSessions::HostMemory& used, Moment now) const {
  const auto fits = [&](TaskId id) {
    const TaskRow& task = durable_.tasks.at(id);
    return memory_for(task) <= workers_.free_memory(worker, used) &&
           has_time_for(workers_.at(worker), task, now) &&
           std::all_of(task.inputs.begin(), task.inputs.end(), has_file_);
  };
  const auto found = std::find_if(late.begin(), late.end(), fits);
  if (found == late.end()) return {};
  const TaskId task = *found;
  late.erase(found);
  return task;
}

/// The ended attempt leaves its task to the one that races it, if there is one.
void JobState::leave_race(const AttemptRow& ended) {
  TaskRow& task = edit(ended.task);
  if (const auto goes_on = races_.leave(task.id, ended.id, task.attempt)) {
    AttemptRow& other = durable_.running_attempts.at(*goes_on);
    other.is_rival = false;
    changes_.put(other);
    task.attempt = other.id;
  } else if (!ended.is_rival) {
    task.attempt = {};
  }
}

/// Ends every running attempt of the task, and tells their workers.
void JobState::revoke_attempts(TaskRow& task, const std::string& why, Moment now) {
  while (task.attempt && durable_.running_attempts.contains(task.attempt)) {
    const AttemptId attempt = task.attempt;
    const WorkerId worker = durable_.running_attempts.at(attempt).worker;
    lose_attempt(attempt, AttemptState::revoked, why, now);
    if (workers_.has(worker)) {
      commands_.emplace_back(SendAccepted{worker, task.id, attempt, false});
    }
  }
}

}  // namespace tetfarm
