/// JobState, the part about workers: sessions, leases and handing out.
#include <algorithm>
#include <optional>
#include <utility>

#include "base/check.h"
#include "coordinator/decisions/job_state.h"
#include "coordinator/decisions/mesh_share.h"

namespace tetfarm {

void JobState::worker_is_ready(WorkerId worker, Moment now) {
  Session& session = sessions_.at(worker);
  session.heard_ms = now.steady_ms;
  if (session.attempt) {
    const TaskRow& task = durable_.tasks.at(durable_.running_attempts.at(session.attempt).task);
    commands_.emplace_back(SendAssign{worker, task.id, session.attempt, limit_ms(task)});
  } else if (session.drains) {
    commands_.emplace_back(SendDrain{worker});
  } else {
    idle_.insert(worker);
  }
}

void JobState::heartbeat(WorkerId worker, TaskId task, AttemptId attempt, Moment now) {
  sessions_.at(worker).heard_ms = now.steady_ms;
  if (!attempt) return;
  if (holds(worker, task, attempt)) {
    leases_.renew(attempt, now.steady_ms);
  } else {
    commands_.emplace_back(SendAccepted{worker, task, attempt, was_accepted(task, attempt)});
  }
}

void JobState::note_work(WorkerId worker, TaskId task, AttemptId attempt, const WorkCount& count) {
  if (!holds(worker, task, attempt)) return;
  const TaskRow& row = durable_.tasks.at(task);
  const double share =
      row.kind == TaskKind::mesh
          ? mesh_share(count, parameter_or_zero(row, "work"), parameter_or_zero(row, "needles"))
          : 0;
  leases_.note_work(attempt, count, share);
}

void JobState::worker_left(WorkerId worker, bool lost, Moment now) {
  const auto session = sessions_.find(worker);
  if (session == sessions_.end()) return;
  const AttemptId attempt = session->second.attempt;
  if (attempt) {
    lose_attempt(attempt, lost ? AttemptState::lost : AttemptState::returned,
                 lost ? "the worker was lost" : "handed back", now);
  }
  forget_process(worker);
  idle_.erase(worker);
  memories_.erase(memories_.find(session->second.reach_bytes));
  sessions_.erase(worker);
  auto row = workers_.extract(worker);
  row.mapped().gone = true;
  changes_.put(row.mapped());
  changes_.add(
      {now.wall_ms, {}, {}, {}, worker, lost ? "worker lost" : "worker left", row.mapped().host});
}

/// For people: what the attempt said and took; committed with its end.
void JobState::store_log(AttemptId attempt, const std::string& log, std::uint64_t peak_rss_bytes) {
  AttemptRow& row = durable_.running_attempts.at(attempt);
  row.log = log;
  row.peak_rss_bytes = peak_rss_bytes;
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
  changes_.put(row);
  leases_.end(row);
  leave_race(row);
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
  delays_.failed_on(task.id, row.worker, now.steady_ms);
  if (!task.attempt) set_state(task, TaskState::ready);
  if (state == AttemptState::lost) count_loss(task, message, now);
}

bool JobState::hold_back(const std::string& message, Moment now) {
  return disk_pause_.begin(message, now.steady_ms);
}

void JobState::out_of_resources(const std::string& message, Moment now) {
  if (!hold_back(message, now)) return;
  changes_.add({now.wall_ms, {}, {}, {}, {}, "stuck", message});
}

/// Every lease and every silence is over a term after some event, none before the first that was
/// found at the last look: until then nothing needs to be looked at.
void JobState::end_leases(Moment now) {
  if (now.steady_ms <= next_end_ms_) return;
  for (const AttemptId attempt : leases_.run_out(now.steady_ms)) {
    // Losing the one before may have put the task that both worked on into quarantine.
    if (!leases_.has(attempt)) continue;
    lose_attempt(attempt, AttemptState::lost, "its lease ran out", now);
  }
  std::vector<WorkerId> silent;
  for (const auto& [worker, session] : sessions_) {
    if (session.heard_ms + rules_.lease_ms < now.steady_ms) silent.push_back(worker);
  }
  for (const WorkerId worker : silent) worker_left(worker, true, now);
  next_end_ms_ = now.steady_ms + rules_.lease_ms;
  next_end_ms_ = std::min(next_end_ms_, leases_.first_end_ms().value_or(next_end_ms_));
  for (const auto& [worker, session] : sessions_) {
    next_end_ms_ = std::min(next_end_ms_, session.heard_ms + rules_.lease_ms);
  }
}

void JobState::tick(Moment now) {
  end_leases(now);
  if (disk_pause_.wait_ms(now.steady_ms) == 0) hand_out(now);
  end_hopeless_jobs(now);
}

std::size_t JobState::drain(WorkerId worker) {
  std::size_t count = 0;
  for (auto& [id, session] : sessions_) {
    if (worker && id != worker) continue;
    session.drains = true;
    idle_.erase(id);
    commands_.emplace_back(SendDrain{id});
    ++count;
  }
  return count;
}

std::vector<WorkerAtWork> JobState::workers_at_work() const {
  std::vector<WorkerAtWork> all;
  for (const auto& [id, session] : sessions_) {
    const auto attempt = durable_.running_attempts.find(session.attempt);
    const TaskId task =
        attempt == durable_.running_attempts.end() ? TaskId{} : attempt->second.task;
    all.push_back({workers_.at(id), task, session.attempt, session.drains, session.tag});
  }
  return all;
}

bool JobState::may_work(WorkerId worker) const {
  return !sessions_.at(worker).attempt &&
         !durable_.quarantined_hosts.contains(workers_.at(worker).host);
}

/// Who has nothing else to do races a task that is late.
void JobState::hand_out(Moment now) {
  std::optional<HostMemory> known;
  std::optional<std::vector<TaskId>> late;
  for (auto next = idle_.begin(); next != idle_.end();) {
    if (lists_.offers().empty() && !late) late = late_tasks(now);
    if (lists_.offers().empty() && late->empty()) return;
    const WorkerId worker = *next++;  // it is idle no more when it is given a task
    if (!may_work(worker)) continue;
    if (!known) known = used_memory();
    HostMemory& used = *known;
    TaskId task = pick_for(worker, used, now);
    if (!task && !late) late = late_tasks(now);
    if (!task) task = pick_late(worker, *late, used, now);
    if (task) lease(worker, task, used, now);
  }
}

/// Whether a ready task may go to the worker now: not before its back-off is over, elsewhere than
/// where it failed for a while, on another host than where it crashed, with time and room for it.
bool JobState::suits(WorkerId worker, TaskId id, std::uint64_t free_bytes, Moment now) const {
  if (delays_.wait_ms(id, now.steady_ms) > 0) return false;
  if (sessions_.size() > 1 && delays_.prefers_other(id, worker, now.steady_ms)) return false;
  const TaskRow& task = durable_.tasks.at(id);
  return memory_for(task) <= free_bytes && has_time_for(sessions_.at(worker), task, now) &&
         !waits_for_another_host(task, workers_.at(worker).host, now);
}

/// The best task for a worker; 0 when there is none for it now. Tasks whose inputs turn out to be
/// gone start to wait.
TaskId JobState::pick_for(WorkerId worker, const HostMemory& used, Moment now) {
  const std::uint64_t free_bytes = free_memory(worker, used);
  std::vector<TaskId> incomplete;
  TaskId picked;
  for (const auto& [rank, id] : lists_.offers()) {
    if (!suits(worker, id, free_bytes, now)) continue;
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

void JobState::lease(WorkerId worker, TaskId task, HostMemory& used, Moment now) {
  Session& session = sessions_.at(worker);
  TF_CHECK(may_work(worker));
  AttemptRow attempt;
  attempt.id = AttemptId{++durable_.last_attempt};
  attempt.task = task;
  attempt.worker = worker;
  attempt.started_ms = now.wall_ms;
  TaskRow& row = edit(task);
  attempt.nonce_hash = session.process.nonce_hash;
  attempt.key = session.process.key;
  attempt.host = workers_.at(worker).host;
  attempt.memory_bytes = session.shares_memory ? memory_for(row) : workers_.at(worker).memory_bytes;
  attempt.is_rival = row.state == TaskState::leased;
  durable_.running_attempts.emplace(attempt.id, attempt);
  changes_.put(attempt);
  leases_.begin(attempt, now.steady_ms);
  session.attempt = attempt.id;
  idle_.erase(worker);
  if (session.shares_memory) used[workers_.at(worker).host] += attempt.memory_bytes;
  if (attempt.is_rival) {
    races_.begin(task, attempt.id);
  } else {
    row.attempt = attempt.id;
    set_state(row, TaskState::leased);
  }
  record(now, row, attempt.id, worker, attempt.is_rival ? "races" : "assigned");
  commands_.emplace_back(SendAssign{worker, task, attempt.id, limit_ms(row)});
}

}  // namespace tetfarm
