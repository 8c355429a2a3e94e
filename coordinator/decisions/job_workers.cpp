/// JobState, the part about workers: sessions, leases and handing out.
#include <algorithm>
#include <optional>
#include <utility>

#include "base/check.h"
#include "coordinator/decisions/job_state.h"
#include "coordinator/decisions/mesh_share.h"
#include "coordinator/decisions/task_rows.h"

namespace tetfarm {

void JobState::worker_is_ready(WorkerId worker, Moment now) {
  workers_.hear(worker, now.steady_ms);
  const WorkerSession& session = workers_.at(worker);
  if (session.attempt) {
    const TaskRow& task = durable_.tasks.at(durable_.running_attempts.at(session.attempt).task);
    commands_.emplace_back(SendAssign{worker, task.id, session.attempt, limit_ms(task)});
  } else if (session.drains) {
    commands_.emplace_back(SendDrain{worker});
  } else {
    workers_.wait(worker);
  }
}

void JobState::heartbeat(WorkerId worker, TaskId task, AttemptId attempt, Moment now) {
  workers_.hear(worker, now.steady_ms);
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
  const ToldSize told = told_size(row).value_or(ToldSize{});
  const double share =
      row.kind == TaskKind::mesh ? mesh_share(count, told.elements, told.needles) : 0;
  leases_.note_work(attempt, count, share);
}

void JobState::worker_left(WorkerId worker, bool lost, Moment now) {
  if (!workers_.has(worker)) return;
  if (const AttemptId attempt = workers_.at(worker).attempt) {
    lose_attempt(attempt, lost ? AttemptState::lost : AttemptState::returned,
                 lost ? "the worker was lost" : "handed back", now);
  }
  WorkerRow row = workers_.leave(worker);
  row.gone = true;
  changes_.put(row);
  changes_.add({now.wall_ms, {}, {}, {}, worker, lost ? "worker lost" : "worker left", row.host});
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
  workers_.let_go(row.worker, attempt);
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
  for (const WorkerId worker : workers_.silent_since(now.steady_ms - rules_.lease_ms)) {
    worker_left(worker, true, now);
  }
  next_end_ms_ = now.steady_ms + rules_.lease_ms;
  next_end_ms_ = std::min(next_end_ms_, leases_.first_end_ms().value_or(next_end_ms_));
  if (const auto heard_ms = workers_.longest_silent_ms()) {
    next_end_ms_ = std::min(next_end_ms_, *heard_ms + rules_.lease_ms);
  }
}

void JobState::tick(Moment now) {
  end_leases(now);
  settle_waiting_jobs(now);
  if (disk_pause_.wait_ms(now.steady_ms) == 0) hand_out(now);
  end_hopeless_jobs(now);
  settle_waiting_jobs(now);
}

std::size_t JobState::drain(WorkerId worker) {
  std::size_t count = 0;
  for (const auto& [id, session] : workers_.all()) {
    if (worker && id != worker) continue;
    workers_.drain(id);
    commands_.emplace_back(SendDrain{id});
    ++count;
  }
  return count;
}

std::vector<WorkerAtWork> JobState::workers_at_work() const {
  std::vector<WorkerAtWork> all;
  for (const auto& [id, session] : workers_.all()) {
    const auto attempt = durable_.running_attempts.find(session.attempt);
    const TaskId task =
        attempt == durable_.running_attempts.end() ? TaskId{} : attempt->second.task;
    all.push_back({session.row, task, session.attempt, session.drains, session.terms.tag});
  }
  return all;
}

bool JobState::may_work(WorkerId worker) const {
  const WorkerSession& session = workers_.at(worker);
  return !session.attempt && !durable_.quarantined_hosts.contains(session.row.host);
}

/// Who has nothing else to do races a task that is late.
void JobState::hand_out(Moment now) {
  std::optional<WorkerSessions::HostMemory> known;
  std::optional<std::vector<TaskId>> late;
  std::optional<UsersAtWork> users;
  for (auto next = workers_.idle().begin(); next != workers_.idle().end();) {
    if (lists_.offers().empty() && !late) late = late_tasks(now);
    if (lists_.offers().empty() && late->empty()) return;
    const WorkerId worker = *next++;  // it is idle no more when it is given a task
    if (!may_work(worker)) continue;
    if (!known) known = workers_.used_memory(durable_.running_attempts);
    WorkerSessions::HostMemory& used = *known;
    if (!users) users = users_at_work();
    TaskId task = pick_for(worker, used, *users, now);
    if (task) ++(*users)[durable_.jobs.at(durable_.tasks.at(task).job).owner];
    if (!task && !late) late = late_tasks(now);
    if (!task) task = pick_late(worker, *late, used, now);
    if (task) lease(worker, task, used, now);
  }
}

/// Whether the worker does tasks of this kind at all.
bool JobState::does_kind(const WorkerSession& session, TaskKind kind) {
  return session.terms.runs_solvers || !traits_of(kind).is_of_others;
}

/// Whether a ready task may go to the worker now: not before its back-off is over, elsewhere than
/// where it failed for a while, on another host than where it crashed, with time and room for it.
bool JobState::suits(WorkerId worker, TaskId id, std::uint64_t free_bytes, Moment now) const {
  if (delays_.wait_ms(id, now.steady_ms) > 0) return false;
  if (worker_count() > 1 && delays_.prefers_other(id, worker, now.steady_ms)) return false;
  const TaskRow& task = durable_.tasks.at(id);
  return does_kind(workers_.at(worker), task.kind) && memory_for(task) <= free_bytes &&
         has_time_for(workers_.at(worker), task, now) &&
         !waits_for_another_host(task, workers_.at(worker).row.host, now);
}

/// Of races only the first attempt counts: it is not the user's doing that there is another.
UsersAtWork JobState::users_at_work() const {
  UsersAtWork users;
  for (const auto& [id, attempt] : durable_.running_attempts) {
    if (!attempt.is_rival) ++users[durable_.jobs.at(durable_.tasks.at(attempt.task).job).owner];
  }
  return users;
}

/// The best task for a worker; 0 when there is none for it now. Tasks whose inputs turn out to be
/// gone start to wait.
TaskId JobState::pick_for(WorkerId worker, const WorkerSessions::HostMemory& used,
                          const UsersAtWork& users, Moment now) {
  const std::uint64_t free_bytes = workers_.free_memory(worker, used);
  std::vector<TaskId> incomplete;
  TaskId picked;
  FairTurns turns(lists_.offers_of_users(), users);
  for (std::optional<TaskId> turn = turns.next(); turn; turn = turns.next()) {
    const TaskId id = *turn;
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

void JobState::lease(WorkerId worker, TaskId task, WorkerSessions::HostMemory& used, Moment now) {
  const WorkerSession& session = workers_.at(worker);
  TF_CHECK(may_work(worker));
  AttemptRow attempt;
  attempt.id = AttemptId{++durable_.last_attempt};
  attempt.task = task;
  attempt.worker = worker;
  attempt.started_ms = now.wall_ms;
  TaskRow& row = edit(task);
  attempt.nonce_hash = session.terms.process.nonce_hash;
  attempt.key = session.terms.process.key;
  attempt.host = session.row.host;
  attempt.memory_bytes = session.terms.shares_memory ? memory_for(row) : session.row.memory_bytes;
  attempt.is_rival = row.state == TaskState::leased;
  durable_.running_attempts.emplace(attempt.id, attempt);
  changes_.put(attempt);
  leases_.begin(attempt, now.steady_ms);
  workers_.hold(worker, attempt.id);
  if (session.terms.shares_memory) used[session.row.host] += attempt.memory_bytes;
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
