/// JobState, the part that looks for broken invariants, by their numbers in job_state.h; each part
/// of the state looks for its own.
#include <algorithm>

#include "coordinator/decisions/job_state.h"

namespace tetfarm {
namespace {

std::string with_number(const char* what, std::uint64_t number) {
  return what + (" " + std::to_string(number));
}

}  // namespace

/// 1 and 2, from the tasks' side.
void JobState::find_broken_tasks(Complaints& broken) const {
  for (const auto& [id, task] : durable_.tasks) {
    const std::string name = with_number("task", id.value);
    const bool runs = task.attempt && durable_.running_attempts.contains(task.attempt);
    if ((task.state == TaskState::leased) != runs) {
      broken.push_back(name + ": leased without attempt, or reverse");
    }
    if (task.state == TaskState::done && !task.attempt) broken.push_back(name + ": done by nobody");
  }
}

/// The same, from the attempts' side.
void JobState::find_broken_attempts(Complaints& broken) const {
  for (const auto& [id, attempt] : durable_.running_attempts) {
    const auto report = [&broken, task_id = attempt.task.value](const char* what) {
      broken.push_back(with_number("task", task_id) + ": " + what);
    };
    const TaskRow& task = durable_.tasks.at(attempt.task);
    if ((task.attempt == id) == attempt.is_rival) report("has a stray attempt");
    if (task.state != TaskState::leased) report("runs, and is not leased");
    if (attempt.state != AttemptState::running) report("runs in an attempt that is over");
  }
}

/// 8 and 9.
void JobState::find_broken_waiting(Complaints& broken) const {
  for (const auto& [id, job] : durable_.jobs) {
    const bool waits = job.phase == JobPhase::waiting;
    const bool is_ordered = std::is_sorted(job.after.begin(), job.after.end()) &&
                            (job.after.empty() || job.after.back() < id);
    if (waits != waiting_jobs_.contains(id)) {
      broken.push_back(job_name(id) + ": wrongly listed as waiting, or not");
    }
    if (job.end_untold != untold_ends_.contains(id)) {
      broken.push_back(job_name(id) + ": wrongly listed as untold, or not");
    }
    if (!is_ordered || (waits && job.after.empty())) {
      broken.push_back(job_name(id) + ": waits for what it must not, or nothing");
    }
  }
}

std::vector<std::string> JobState::validate() const {
  Complaints broken;
  find_broken_waiting(broken);
  find_broken_tasks(broken);
  find_broken_attempts(broken);
  for (const Complaints& part :
       {workers_.validate(durable_.running_attempts), leases_.validate(durable_.running_attempts),
        races_.validate(durable_.running_attempts, durable_.tasks),
        delays_.validate(durable_.tasks), lists_.validate(durable_.tasks, durable_.jobs),
        progress_.validate(durable_.subdomains), host_crashes_.validate(),
        file_needs_.validate(durable_)}) {
    broken.insert(broken.end(), part.begin(), part.end());
  }
  return broken;
}

}  // namespace tetfarm
