/// JobState, the part about workers: sessions, leases and handing out.
#include <algorithm>
#include <utility>

#include "base/check.h"
#include "coordinator/job_state.h"

namespace tetfarm {

bool JobState::is_current(TaskId task, AttemptId attempt) const {
  const auto found = durable_.running_attempts.find(attempt);
  return found != durable_.running_attempts.end() && found->second.task == task;
}

bool JobState::was_accepted(TaskId task, AttemptId attempt) const {
  const auto found = durable_.tasks.find(task);
  return found != durable_.tasks.end() && attempt && found->second.attempt == attempt &&
         found->second.state == TaskState::done;
}

WorkerId JobState::add_worker(const WorkerInfo& info, TaskId task, AttemptId attempt, Moment now) {
  const WorkerId id{++durable_.last_worker};
  WorkerRow row;
  row.id = id;
  row.host = info.host;
  row.process = info.process;
  row.cores = info.cores;
  row.memory_bytes = info.memory_bytes;
  row.program_version = info.program_version;
  row.seen_ms = now.wall_ms;
  workers_[id] = row;
  dirty_workers_[id] = row;
  sessions_[id].heard_ms = now.steady_ms;
  new_events_.push_back({now.wall_ms,
                         {},
                         {},
                         {},
                         id,
                         "worker",
                         info.host + " process " + std::to_string(info.process)});
  commands_.emplace_back(SendWelcome{id, take_over(id, task, attempt, now)});
  return id;
}

void JobState::greet_again(WorkerId worker, TaskId task, AttemptId attempt, Moment now) {
  sessions_.at(worker).heard_ms = now.steady_ms;
  commands_.emplace_back(SendWelcome{worker, take_over(worker, task, attempt, now)});
}

/// The attempt moves to `worker`, which is the same process on a new connection. False when it is
/// stale.
bool JobState::take_over(WorkerId worker, TaskId task, AttemptId attempt, Moment now) {
  if (!attempt || !is_current(task, attempt)) return false;
  AttemptRow& row = durable_.running_attempts.at(attempt);
  if (row.worker != worker) {
    const AttemptId held = sessions_.at(worker).attempt;
    if (held) lose_attempt(held, AttemptState::lost, "its worker went on with another", now);
    if (sessions_.contains(row.worker)) {
      sessions_.at(row.worker).attempt = {};
      worker_left(row.worker, false, now);
    }
    row.worker = worker;
    dirty_attempts_[attempt] = row;
    record(now, durable_.tasks.at(task), attempt, worker, "reconnected");
  }
  sessions_.at(worker).attempt = attempt;
  sessions_.at(worker).ready = false;
  lease_ends_ms_[attempt] = now.steady_ms + rules_.lease_ms;
  return true;
}

void JobState::worker_is_ready(WorkerId worker, Moment now) {
  Session& session = sessions_.at(worker);
  session.heard_ms = now.steady_ms;
  if (session.attempt) {
    const TaskId task = durable_.running_attempts.at(session.attempt).task;
    commands_.emplace_back(SendAssign{worker, task, session.attempt});
  } else {
    session.ready = true;
  }
}

void JobState::heartbeat(WorkerId worker, TaskId task, AttemptId attempt, Moment now) {
  sessions_.at(worker).heard_ms = now.steady_ms;
  if (!attempt) return;
  if (is_current(task, attempt) && durable_.running_attempts.at(attempt).worker == worker) {
    lease_ends_ms_[attempt] = now.steady_ms + rules_.lease_ms;
  } else {
    commands_.emplace_back(SendAccepted{worker, task, attempt, was_accepted(task, attempt)});
  }
}

void JobState::worker_left(WorkerId worker, bool lost, Moment now) {
  const auto session = sessions_.find(worker);
  if (session == sessions_.end()) return;
  const AttemptId attempt = session->second.attempt;
  if (attempt) {
    lose_attempt(attempt, lost ? AttemptState::lost : AttemptState::returned,
                 lost ? "the worker was lost" : "handed back", now);
  }
  sessions_.erase(worker);
  auto row = workers_.extract(worker);
  row.mapped().gone = true;
  dirty_workers_[worker] = row.mapped();
  new_events_.push_back(
      {now.wall_ms, {}, {}, {}, worker, lost ? "worker lost" : "worker left", row.mapped().host});
}

/// Takes the attempt out of the running ones; its task must be given a new state right after.
AttemptRow JobState::end_attempt(AttemptId attempt, AttemptState state, const std::string& message,
                                 Moment now) {
  auto node = durable_.running_attempts.extract(attempt);
  TF_CHECK(!node.empty());
  AttemptRow row = std::move(node.mapped());
  row.state = state;
  row.message = message;
  row.ended_ms = now.wall_ms;
  dirty_attempts_[attempt] = row;
  lease_ends_ms_.erase(attempt);
  const auto session = sessions_.find(row.worker);
  if (session != sessions_.end() && session->second.attempt == attempt) {
    session->second.attempt = {};
  }
  record(now, durable_.tasks.at(row.task), attempt, row.worker, name_of(state), message);
  return row;
}

void JobState::lose_attempt(AttemptId attempt, AttemptState state, const std::string& message,
                            Moment now) {
  const AttemptRow row = end_attempt(attempt, state, message, now);
  TaskRow& task = edit(row.task);
  task.attempt = {};
  failed_on_[task.id] = row.worker;
  not_before_ms_[task.id] = now.steady_ms;
  set_state(task, TaskState::ready);
  if (state == AttemptState::lost) count_loss(task, message, now);
}

void JobState::out_of_resources(const std::string& message, Moment now) {
  stuck_message_ = message;
  if (is_stuck() && now.steady_ms < stuck_until_ms_) return;
  stuck_delay_ms_ =
      is_stuck() ? std::min(2 * stuck_delay_ms_, rules_.longest_delay_ms) : rules_.crash_delay_ms;
  stuck_until_ms_ = now.steady_ms + stuck_delay_ms_;
  new_events_.push_back({now.wall_ms, {}, {}, {}, {}, "stuck", message});
}

void JobState::tick(Moment now) {
  std::vector<AttemptId> ended;
  for (const auto& [attempt, end_ms] : lease_ends_ms_) {
    if (end_ms < now.steady_ms) ended.push_back(attempt);
  }
  for (const AttemptId attempt : ended) {
    lose_attempt(attempt, AttemptState::lost, "its lease ran out", now);
  }
  std::vector<WorkerId> silent;
  for (const auto& [worker, session] : sessions_) {
    if (session.heard_ms + rules_.lease_ms < now.steady_ms) silent.push_back(worker);
  }
  for (const WorkerId worker : silent) worker_left(worker, true, now);
  if (!is_stuck() || now.steady_ms >= stuck_until_ms_) hand_out(now);
}

void JobState::hand_out(Moment now) {
  for (auto& [worker, session] : sessions_) {
    if (offers_.empty()) return;
    if (!session.ready || session.attempt) continue;
    const TaskId task = pick_for(worker, now);
    if (task) lease(worker, task, now);
  }
}

/// The best task for a worker; 0 when there is none for it now. Tasks whose inputs turn out to be
/// gone start to wait.
TaskId JobState::pick_for(WorkerId worker, Moment now) {
  std::vector<TaskId> incomplete;
  TaskId picked;
  for (const auto& [rank, id] : offers_) {
    const auto not_before = not_before_ms_.find(id);
    const std::int64_t from_ms = not_before == not_before_ms_.end() ? 0 : not_before->second;
    if (not_before != not_before_ms_.end() && now.steady_ms < from_ms) continue;
    const auto failed_on = failed_on_.find(id);
    const bool failed_here = failed_on != failed_on_.end() && failed_on->second == worker;
    if (failed_here && sessions_.size() > 1 && now.steady_ms < from_ms + rules_.elsewhere_ms) {
      continue;
    }
    const std::vector<ArtifactRef>& inputs = durable_.tasks.at(id).inputs;
    if (std::all_of(inputs.begin(), inputs.end(), has_file_)) {
      picked = id;
      break;
    }
    incomplete.push_back(id);
  }
  for (const TaskId id : incomplete) settle_waiting(id, now);
  return picked;
}

void JobState::lease(WorkerId worker, TaskId task, Moment now) {
  Session& session = sessions_.at(worker);
  AttemptRow attempt;
  attempt.id = AttemptId{++durable_.last_attempt};
  attempt.task = task;
  attempt.worker = worker;
  attempt.started_ms = now.wall_ms;
  durable_.running_attempts.emplace(attempt.id, attempt);
  dirty_attempts_[attempt.id] = attempt;
  lease_ends_ms_[attempt.id] = now.steady_ms + rules_.lease_ms;
  session.attempt = attempt.id;
  session.ready = false;
  TaskRow& row = edit(task);
  row.attempt = attempt.id;
  set_state(row, TaskState::leased);
  record(now, row, attempt.id, worker, "assigned");
  commands_.emplace_back(SendAssign{worker, task, attempt.id});
}

}  // namespace tetfarm
