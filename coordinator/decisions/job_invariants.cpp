/// JobState, the part that looks for broken invariants, by their numbers in job_state.h, and for
/// indexes that do not agree with the rows they were made from.
#include <tuple>
#include <utility>

#include "coordinator/decisions/job_state.h"

namespace tetfarm {
namespace {

std::string with_number(const char* what, std::uint64_t number) {
  return what + (" " + std::to_string(number));
}

}  // namespace

/// 1, 2, 4, and that a task is listed where its state says.
void JobState::find_broken_tasks(Complaints& broken) const {
  const auto lists = [](const std::map<JobId, std::set<TaskId>>& tasks, const TaskRow& task) {
    const auto list = tasks.find(task.job);
    return list != tasks.end() && list->second.contains(task.id);
  };
  std::size_t offered = 0;
  std::size_t at_work = 0;
  std::size_t failed = 0;
  for (const auto& [id, task] : durable_.tasks) {
    const auto report = [&broken, task_id = id.value](const char* what) {
      broken.push_back(with_number("task", task_id) + ": " + what);
    };
    const bool runs = task.attempt && durable_.running_attempts.contains(task.attempt);
    if ((task.state == TaskState::leased) != runs) report("leased without attempt, or reverse");
    if (task.state == TaskState::done && !task.attempt) report("done by nobody");
    const bool should =
        task.state == TaskState::ready && durable_.jobs.at(task.job).phase == JobPhase::running;
    if (offers_.contains(offer_of(task)) != should) report("wrongly on offer or not on offer");
    const bool is_active = task.state == TaskState::ready || task.state == TaskState::leased;
    if (lists(active_, task) != is_active) report("wrongly listed as active, or not");
    const bool has_failed = task.state == TaskState::failed;
    if (lists(failed_, task) != has_failed) report("wrongly listed as failed, or not");
    if (should) ++offered;
    if (is_active) ++at_work;
    if (has_failed) ++failed;
  }
  const auto count = [](const std::map<JobId, std::set<TaskId>>& tasks) {
    std::size_t all = 0;
    for (const auto& [job, list] : tasks) all += list.size();
    return all;
  };
  if (offers_.size() != offered) broken.emplace_back("a task on offer that does not exist");
  if (count(active_) != at_work) broken.emplace_back("an active task that does not exist");
  if (count(failed_) != failed) broken.emplace_back("a failed task that does not exist");
}

/// 6: who has a place has it alone, and who has none was replaced.
void JobState::find_broken_places(Complaints& broken) const {
  std::size_t placed = 0;
  for (const auto& [id, task] : durable_.tasks) {
    const auto place = places_.find({task.job, task.kind, task.path});
    const bool has_place = place != places_.end() && place->second == id;
    if (has_place) ++placed;
    if (has_place != (task.state == TaskState::replaced)) continue;
    broken.push_back(with_number("task", id.value) + ": has no place, or was replaced and has one");
  }
  if (placed != places_.size()) broken.emplace_back("a place of a task that does not exist");
}

/// 1, 2, 3 and 7, from the attempts' side.
void JobState::find_broken_attempts(Complaints& broken) const {
  std::map<Process, AttemptId> held;
  for (const auto& [id, attempt] : durable_.running_attempts) {
    const auto report = [&broken, task_id = attempt.task.value](const char* what) {
      broken.push_back(with_number("task", task_id) + ": " + what);
    };
    const auto rival = rivals_.find(attempt.task);
    const bool races = rival != rivals_.end() && rival->second == id;
    if (races != attempt.is_rival) report("has a rival that is none, or reverse");
    const TaskRow& task = durable_.tasks.at(attempt.task);
    if ((task.attempt == id) == races) report("has a stray attempt");
    if (task.state != TaskState::leased) report("runs, and is not leased");
    if (!started_ms_.contains(id)) report("runs since nobody knows when");
    if (!lease_ends_ms_.contains(id)) report("runs without a lease");
    if (attempt.state != AttemptState::running) report("runs in an attempt that is over");
    if (attempt.nonce_hash.empty()) continue;
    if (!held.emplace(process_of(attempt), id).second) report("runs in a process with another");
  }
  if (held != process2attempt_) broken.emplace_back("a process holds what it does not run");
  if (lease_ends_ms_.size() != durable_.running_attempts.size()) {
    broken.emplace_back("a lease without a running attempt");
  }
  for (const auto& [attempt, work] : works_) {
    if (durable_.running_attempts.contains(attempt)) continue;
    broken.push_back(with_number("work of attempt", attempt.value) + ", which is over");
  }
  for (const auto& [task, rival] : rivals_) {
    if (durable_.running_attempts.contains(rival)) continue;
    broken.push_back(with_number("task", task.value) + ": is raced by nobody");
  }
}

/// 3, from the workers' side.
void JobState::find_broken_sessions(Complaints& broken) const {
  for (const auto& [id, session] : sessions_) {
    const std::string worker = with_number("worker", id.value);
    if (!workers_.contains(id)) broken.push_back(worker + " is here without a row");
    if (idle_.contains(id) && session.attempt) broken.push_back(worker + " is idle and works");
    if (!session.attempt) continue;
    const auto found = durable_.running_attempts.find(session.attempt);
    if (found == durable_.running_attempts.end() || found->second.worker != id) {
      broken.push_back(worker + " holds what is not its own");
    } else if (process_of(found->second) != session.process) {
      broken.push_back(worker + " holds another process's attempt");
    }
  }
  for (const WorkerId worker : idle_) {
    if (sessions_.contains(worker)) continue;
    broken.push_back(with_number("worker", worker.value) + " is idle and gone");
  }
  for (const auto& [process, worker] : process2worker_) {
    const auto session = sessions_.find(worker);
    if (session != sessions_.end() && session->second.process == process) continue;
    broken.push_back(with_number("worker", worker.value) + " is named for another's process");
  }
  if (memories_.size() != sessions_.size()) broken.emplace_back("memory of a worker that is gone");
}

/// What is counted of each job's tree, counted again.
void JobState::find_broken_counts(Complaints& broken) const {
  std::map<JobId, std::tuple<std::int64_t, std::int64_t, std::int64_t>> counted;
  for (const auto& [key, subdomain] : durable_.subdomains) {
    auto& [unsettled, open, leaves] = counted[subdomain.job];
    if (!is_settled(subdomain)) ++unsettled;
    if (subdomain.state == SubdomainState::open) ++open;
    if (subdomain.state == SubdomainState::leaf) ++leaves;
  }
  const auto known = [](const std::map<JobId, std::int64_t>& counts, JobId job) {
    const auto found = counts.find(job);
    return found == counts.end() ? 0 : found->second;
  };
  for (const JobId job : at_hand_) {
    const std::tuple kept{known(unsettled_, job), known(open_, job), known(leaves_, job)};
    if (kept == counted[job]) continue;
    broken.push_back(with_number("job", job.value) + ": its sub-domains are miscounted");
  }
}

std::vector<std::string> JobState::validate() const {
  Complaints broken;
  find_broken_tasks(broken);
  find_broken_places(broken);
  find_broken_attempts(broken);
  find_broken_sessions(broken);
  find_broken_counts(broken);
  return broken;
}

}  // namespace tetfarm
