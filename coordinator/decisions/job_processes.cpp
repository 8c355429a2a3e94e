/// JobState, the part about who is who: processes, their connections, and which attempts are
/// theirs.
#include <algorithm>

#include "base/sha256.h"
#include "coordinator/decisions/job_state.h"

namespace tetfarm {
namespace {

WorkerProcess process_of(const WorkerInfo& info) {
  return {info.key, info.nonce.empty() ? "" : sha256_hex(info.nonce)};
}

}  // namespace

bool JobState::is_current(TaskId task, AttemptId attempt) const {
  const auto found = durable_.running_attempts.find(attempt);
  return found != durable_.running_attempts.end() && found->second.task == task;
}

/// Only the process that was given an attempt can bring its result.
bool JobState::holds(WorkerId worker, TaskId task, AttemptId attempt) const {
  return is_current(task, attempt) && durable_.running_attempts.at(attempt).worker == worker;
}

bool JobState::was_accepted(TaskId task, AttemptId attempt) const {
  if (!attempt) return false;
  const std::optional<TaskRow> found = find_row(task);
  return found && found->attempt == attempt && found->state == TaskState::done;
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
  changes_.put(row);
  sessions_[id].reach_bytes = std::max(info.memory_bytes, info.pool_memory_bytes);
  memories_.insert(sessions_[id].reach_bytes);
  note_terms(id, info, now);
  changes_.add({now.wall_ms,
                {},
                {},
                {},
                id,
                "worker",
                info.host + " process " + std::to_string(info.process)});
  commands_.emplace_back(SendWelcome{id, settle_in(id, task, attempt, now)});
  return id;
}

void JobState::note_terms(WorkerId worker, const WorkerInfo& info, Moment now) {
  Session& session = sessions_[worker];
  session.heard_ms = now.steady_ms;
  forget_process(worker);
  session.process = process_of(info);
  session.shares_memory = info.shares_memory;
  session.tag = info.tag;
  session.ends_ms = info.ends_in_ms > 0 ? now.steady_ms + info.ends_in_ms : 0;
}

void JobState::greet_again(WorkerId worker, const WorkerInfo& info, TaskId task, AttemptId attempt,
                           Moment now) {
  const AttemptId held = sessions_.at(worker).attempt;
  const bool is_another = sessions_.at(worker).process != process_of(info);
  if (held && is_another) {
    lose_attempt(held, AttemptState::lost, "another process took its place", now);
  }
  note_terms(worker, info, now);
  commands_.emplace_back(SendWelcome{worker, settle_in(worker, task, attempt, now)});
}

/// What the process holds, on this connection or an earlier one, is its own; nothing else is. True
/// when it shall go on with the attempt that it named.
bool JobState::settle_in(WorkerId worker, TaskId task, AttemptId attempt, Moment now) {
  const WorkerProcess process = sessions_.at(worker).process;
  const bool goes_on = take_over(worker, task, attempt, now);
  if (process.nonce_hash.empty()) return goes_on;
  // An assignment that was lost on the way is said again when it is ready.
  if (const auto held = leases_.held_by(process)) move_attempt(*held, worker, now);
  const auto [earlier, is_first] = process2worker_.emplace(process, worker);
  if (!is_first && earlier->second != worker) {
    const WorkerId left = earlier->second;
    earlier->second = worker;
    worker_left(left, false, now);
  }
  return goes_on;
}

void JobState::forget_process(WorkerId worker) {
  const auto process = process2worker_.find(sessions_.at(worker).process);
  if (process != process2worker_.end() && process->second == worker) process2worker_.erase(process);
}

/// False when the attempt is stale, or another process's.
bool JobState::take_over(WorkerId worker, TaskId task, AttemptId attempt, Moment now) {
  if (!attempt || !is_current(task, attempt)) return false;
  if (process_of(durable_.running_attempts.at(attempt)) != sessions_.at(worker).process) {
    return false;
  }
  move_attempt(attempt, worker, now);
  idle_.erase(worker);
  leases_.renew(attempt, now.steady_ms);
  return true;
}

/// To `worker`, which is the same process on a new connection.
void JobState::move_attempt(AttemptId attempt, WorkerId worker, Moment now) {
  AttemptRow& row = durable_.running_attempts.at(attempt);
  Session& session = sessions_.at(worker);
  if (row.worker != worker) {
    if (session.attempt) {
      lose_attempt(session.attempt, AttemptState::lost, "its worker went on with another", now);
    }
    if (sessions_.contains(row.worker)) {
      sessions_.at(row.worker).attempt = {};
      worker_left(row.worker, false, now);
    }
    row.worker = worker;
    row.host = workers_.at(worker).host;
    changes_.put(row);
    record(now, durable_.tasks.at(row.task), attempt, worker, "reconnected");
  }
  session.attempt = attempt;
}

}  // namespace tetfarm
