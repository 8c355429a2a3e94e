/// JobState, the part about who is who: processes, their connections, and which attempts are
/// theirs.
#include <algorithm>

#include "base/sha256.h"
#include "coordinator/decisions/job_state.h"
#include "coordinator/decisions/worker_process.h"

namespace tetfarm {
namespace {

WorkerProcess process_of(const WorkerInfo& info) {
  return {info.key, info.nonce.empty() ? "" : sha256_hex(info.nonce)};
}

SessionTerms terms_of(const WorkerInfo& info, Moment now) {
  return {process_of(info), info.tag, info.shares_memory,
          info.ends_in_ms > 0 ? now.steady_ms + info.ends_in_ms : 0, info.runs_solvers};
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
  changes_.put(row);
  workers_.arrive(row, std::max(info.memory_bytes, info.pool_memory_bytes));
  workers_.introduce(id, terms_of(info, now), now.steady_ms);
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

void JobState::greet_again(WorkerId worker, const WorkerInfo& info, TaskId task, AttemptId attempt,
                           Moment now) {
  const AttemptId held = workers_.at(worker).attempt;
  const bool is_another = workers_.at(worker).terms.process != process_of(info);
  if (held && is_another) {
    lose_attempt(held, AttemptState::lost, "another process took its place", now);
  }
  workers_.introduce(worker, terms_of(info, now), now.steady_ms);
  commands_.emplace_back(SendWelcome{worker, settle_in(worker, task, attempt, now)});
}

/// What the process holds, on this connection or an earlier one, is its own; nothing else is. True
/// when it shall go on with the attempt that it named.
bool JobState::settle_in(WorkerId worker, TaskId task, AttemptId attempt, Moment now) {
  const WorkerProcess process = workers_.at(worker).terms.process;
  const bool goes_on = take_over(worker, task, attempt, now);
  if (process.nonce_hash.empty()) return goes_on;
  // An assignment that was lost on the way is said again when it is ready.
  if (const auto held = leases_.held_by(process)) move_attempt(*held, worker, now);
  if (const auto earlier = workers_.take_seat(worker)) worker_left(*earlier, false, now);
  return goes_on;
}

/// False when the attempt is stale, or another process's.
bool JobState::take_over(WorkerId worker, TaskId task, AttemptId attempt, Moment now) {
  if (!attempt || !is_current(task, attempt)) return false;
  if (process_of(durable_.running_attempts.at(attempt)) != workers_.at(worker).terms.process) {
    return false;
  }
  move_attempt(attempt, worker, now);
  leases_.renew(attempt, now.steady_ms);
  return true;
}

/// To `worker`, which is the same process on a new connection.
void JobState::move_attempt(AttemptId attempt, WorkerId worker, Moment now) {
  AttemptRow& row = durable_.running_attempts.at(attempt);
  if (row.worker != worker) {
    if (const AttemptId other = workers_.at(worker).attempt) {
      lose_attempt(other, AttemptState::lost, "its worker went on with another", now);
    }
    if (workers_.has(row.worker)) {
      workers_.let_go(row.worker, attempt);
      worker_left(row.worker, false, now);
    }
    row.worker = worker;
    row.host = workers_.at(worker).row.host;
    changes_.put(row);
    record(now, durable_.tasks.at(row.task), attempt, worker, "reconnected");
  }
  workers_.hold(worker, attempt);
}

}  // namespace tetfarm
