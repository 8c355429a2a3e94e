#include "coordinator/decisions/job_state.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "coordinator/decisions/task_reuse.h"

namespace tetfarm {

JobState::JobState(DurableState durable, const FarmRules& rules, HasFile has_file, Moment now,
                   const FinishedJobs* finished)
    : durable_(std::move(durable)),
      rules_(rules),
      has_file_(std::move(has_file)),
      leases_(rules.lease_ms),
      delays_(rules.elsewhere_ms),
      disk_pause_(rules.crash_delay_ms, rules.longest_delay_ms) {
  static const FinishedJobs none;
  finished_ = finished == nullptr ? &none : finished;
  expectation_ = finished_->expectation();
  for (const auto& [id, job] : durable_.jobs) {
    if (!job.key.empty()) keys_[{job.owner, job.key}] = id;
    if (job.phase == JobPhase::waiting) waiting_jobs_.insert(id);
    if (job.end_untold) untold_ends_.insert(id);
    durable_.last_job = std::max(durable_.last_job, id.value);
  }
  for (const auto& [key, subdomain] : durable_.subdomains) progress_.add(subdomain);
  for (const auto& [id, task] : durable_.tasks) {
    durable_.last_task = std::max(durable_.last_task, id.value);
    take_in(task);
    if (task.state == TaskState::done) expectation_.learn(task);
  }
  for (const JobId job : at_hand_) note_files_of_tree(job);
  if (!durable_.tasks.empty()) all_back_ms_ = now.steady_ms + rules_.lease_ms;
  for (const auto& [id, attempt] : durable_.running_attempts) {
    leases_.begin(attempt, now.steady_ms);
    if (attempt.is_rival) races_.begin(attempt.task, id);
  }
  for (const auto& [id, job] : durable_.jobs) {
    if (job.phase == JobPhase::running) wake_waiting(id, now);
  }
}

TaskRow& JobState::edit(TaskId task) {
  changes_.note(task);
  return durable_.tasks.at(task);
}

JobRow& JobState::edit(JobId job) {
  changes_.note(job);
  return durable_.jobs.at(job);
}

void JobState::index(const TaskRow& task) {
  lists_.update(task, durable_.jobs.at(task.job));
  note_files(task, files_of(task.job));
}

void JobState::set_state(TaskRow& task, TaskState state) {
  changes_.note(task.id);
  task.state = state;
  index(task);
}

void JobState::set_phase(JobRow& job, JobPhase phase, Moment now) {
  changes_.note(job.id);
  job.phase = phase;
  job.finished_ms = is_end(phase) ? now.wall_ms : 0;
  if (is_end(phase)) some_job_ended_ = true;
  set_untold(job, is_end(phase) && rules_.tells_ends);
  if (phase == JobPhase::waiting) {
    waiting_jobs_.insert(job.id);
  } else {
    waiting_jobs_.erase(job.id);
  }
  for (const TaskId task : lists_.tasks_of(job.id)) index(durable_.tasks.at(task));
}

/// @pre the row is noted as changed.
void JobState::set_untold(JobRow& job, bool is_untold) {
  job.end_untold = is_untold;
  if (is_untold) {
    untold_ends_.insert(job.id);
  } else {
    untold_ends_.erase(job.id);
  }
}

void JobState::end_was_told(JobId id, std::int64_t finished_ms, const std::string& trouble,
                            Moment now) {
  const auto found = durable_.jobs.find(id);
  const bool is_that_end = found != durable_.jobs.end() && found->second.end_untold &&
                           found->second.finished_ms == finished_ms;
  if (!is_that_end) return;
  set_untold(edit(id), false);
  changes_.add(
      {now.wall_ms, id, {}, {}, {}, trouble.empty() ? "end told" : "end not told", trouble});
}

void JobState::put(const SubdomainRow& subdomain) {
  const SubdomainKey key{subdomain.job, subdomain.path};
  const auto [place, is_new] = durable_.subdomains.try_emplace(key, subdomain);
  if (!is_new) {
    progress_.take_away(place->second);
    place->second = subdomain;
  }
  progress_.add(subdomain);
  note_files(subdomain, files_of(subdomain.job));
  changes_.note(key);
}

void JobState::add_task(TaskRow task, Moment now) {
  if (lists_.find(task.job, task.kind, task.path)) return;
  task.id = TaskId{++durable_.last_task};
  at_hand_.insert(task.job);
  lists_.place(task);
  changes_.note(task.id);
  const bool is_waiting = durable_.jobs.at(task.job).phase == JobPhase::waiting;
  const bool served = !is_waiting && is_served(task);
  const TaskRow& added = durable_.tasks.emplace(task.id, std::move(task)).first->second;
  index(added);
  record(now, added, {}, {}, served ? "served" : "ready",
         served ? "as an earlier job has done it" : "");
  if (served) advance(added, now);
}

void JobState::remember_work(const TaskRow& task) {
  if (task.state != TaskState::done) return;
  const Hash128 key = work_key(task, program_of(task));
  done_work_[{key.high, key.low}].insert(task.id);
}

/// A task as it is: also of a finished job, where it is read.
std::optional<TaskRow> JobState::find_row(TaskId task) const {
  const auto found = durable_.tasks.find(task);
  if (found != durable_.tasks.end()) return found->second;
  return finished_->task(task);
}

/// Gives the task the result of an earlier one that serves for it, if its files are still there.
bool JobState::is_served(TaskRow& task) const {
  const Hash128 key = work_key(task, rules_.program);
  std::vector<TaskId> candidates = finished_->did(key);
  const auto own = done_work_.find({key.high, key.low});
  if (own != done_work_.end()) {
    candidates.insert(candidates.end(), own->second.begin(), own->second.end());
  }
  for (const TaskId id : candidates) {
    const std::optional<TaskRow> done = find_row(id);
    if (!done || done->state != TaskState::done || !serves(*done, task) ||
        !std::all_of(done->outputs.begin(), done->outputs.end(), has_file_)) {
      continue;
    }
    take_result(*done, task);
    return true;
  }
  return false;
}

/// By rising heap number.
std::vector<SubdomainRow> JobState::tree_of(JobId job) const {
  std::vector<SubdomainRow> tree;
  for (auto node = durable_.subdomains.lower_bound({job, 0});
       node != durable_.subdomains.end() && node->first.first == job; ++node) {
    tree.push_back(node->second);
  }
  return tree;
}

void JobState::record(Moment now, const TaskRow& task, AttemptId attempt, WorkerId worker,
                      const char* what, const std::string& message) {
  std::string text = name_of(task.kind);
  if (task.path != 0) text += " " + std::to_string(task.path);
  if (!message.empty()) text += ": " + message;
  changes_.add({now.wall_ms, task.job, task.id, attempt, worker, what, text});
}

const TaskRow* JobState::find_task(JobId job, TaskKind kind, std::uint64_t path) const {
  const std::optional<TaskId> found = lists_.find(job, kind, path);
  return found ? &durable_.tasks.at(*found) : nullptr;
}

ChangeSet JobState::take_changes() { return changes_.take(durable_); }

std::vector<Command> JobState::take_commands() { return std::exchange(commands_, {}); }

}  // namespace tetfarm
