#include "coordinator/decisions/job_state.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/check.h"
#include "coordinator/decisions/task_reuse.h"
#include "tasks/task_kind.h"

namespace tetfarm {
JobState::JobState(DurableState durable, const FarmRules& rules, HasFile has_file, Moment now,
                   const FinishedJobs* finished)
    : durable_(std::move(durable)), rules_(rules), has_file_(std::move(has_file)) {
  static const FinishedJobs none;
  finished_ = finished == nullptr ? &none : finished;
  expectation_ = finished_->expectation();
  for (const auto& [id, job] : durable_.jobs) {
    if (!job.key.empty()) keys_[{job.owner, job.key}] = id;
  }
  for (const auto& [key, subdomain] : durable_.subdomains) index(subdomain, true);
  for (const auto& [id, task] : durable_.tasks) {
    durable_.last_task = std::max(durable_.last_task, id.value);
    take_in(task);
    if (task.state == TaskState::done) expectation_.learn(task);
  }
  if (!durable_.tasks.empty()) all_back_ms_ = now.steady_ms + rules_.lease_ms;
  for (const auto& [id, attempt] : durable_.running_attempts) {
    lease_ends_ms_[id] = now.steady_ms + rules_.lease_ms;
    started_ms_[id] = now.steady_ms;
    if (attempt.is_rival) rivals_[attempt.task] = id;
    if (!attempt.nonce_hash.empty()) process2attempt_[process_of(attempt)] = id;
  }
  for (const auto& [id, job] : durable_.jobs) {
    if (job.phase == JobPhase::running) wake_waiting(id, now);
  }
}

JobState::Offer JobState::offer_of(const TaskRow& task) {
  return {traits_of(task.kind).rank, task.id};
}

TaskRow& JobState::edit(TaskId task) {
  dirty_tasks_.insert(task);
  return durable_.tasks.at(task);
}

JobRow& JobState::edit(JobId job) {
  dirty_jobs_.insert(job);
  return durable_.jobs.at(job);
}

void JobState::index(const TaskRow& task) {
  const Offer offer = offer_of(task);
  if (task.state == TaskState::ready && durable_.jobs.at(task.job).phase == JobPhase::running) {
    offers_.insert(offer);
  } else {
    offers_.erase(offer);
  }
  const auto belongs = [&task](std::map<JobId, std::set<TaskId>>& lists, bool should) {
    std::set<TaskId>& list = lists[task.job];
    if (should) {
      list.insert(task.id);
    } else {
      list.erase(task.id);
    }
    if (list.empty()) lists.erase(task.job);
  };
  belongs(active_, task.state == TaskState::ready || task.state == TaskState::leased);
  belongs(failed_, task.state == TaskState::failed);
}

void JobState::index(const SubdomainRow& subdomain, bool adds) {
  const std::int64_t change = adds ? 1 : -1;
  if (!is_settled(subdomain)) unsettled_[subdomain.job] += change;
  if (subdomain.state == SubdomainState::open) open_[subdomain.job] += change;
  if (subdomain.state == SubdomainState::leaf) leaves_[subdomain.job] += change;
}

void JobState::set_state(TaskRow& task, TaskState state) {
  dirty_tasks_.insert(task.id);
  task.state = state;
  index(task);
}

void JobState::set_phase(JobRow& job, JobPhase phase, Moment now) {
  dirty_jobs_.insert(job.id);
  job.phase = phase;
  job.finished_ms = phase == JobPhase::running ? 0 : now.wall_ms;
  for (const TaskId task : tasks_of(job.id)) index(durable_.tasks.at(task));
}

void JobState::put(const SubdomainRow& subdomain) {
  const SubdomainKey key{subdomain.job, subdomain.path};
  const auto [place, is_new] = durable_.subdomains.try_emplace(key, subdomain);
  if (!is_new) {
    index(place->second, false);
    place->second = subdomain;
  }
  index(subdomain, true);
  dirty_subdomains_.insert(key);
}

void JobState::add_task(TaskRow task, Moment now) {
  const Place place{task.job, task.kind, task.path};
  if (places_.contains(place)) return;
  task.id = TaskId{++durable_.last_task};
  at_hand_.insert(task.job);
  places_[place] = task.id;
  dirty_tasks_.insert(task.id);
  const bool served = is_served(task);
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
  new_events_.push_back({now.wall_ms, task.job, task.id, attempt, worker, what, text});
}

const TaskRow* JobState::find_task(JobId job, TaskKind kind, std::uint64_t path) const {
  const auto found = places_.find({job, kind, path});
  return found == places_.end() ? nullptr : &durable_.tasks.at(found->second);
}

std::vector<TaskId> JobState::tasks_of(JobId job) const {
  std::vector<TaskId> tasks;
  for (auto place = places_.lower_bound({job, all_task_kinds.front(), 0});
       place != places_.end() && std::get<JobId>(place->first) == job; ++place) {
    tasks.push_back(place->second);
  }
  return tasks;
}

ChangeSet JobState::take_changes() {
  ChangeSet changes;
  for (const JobId id : dirty_jobs_) changes.jobs.push_back(durable_.jobs.at(id));
  for (const SubdomainKey& key : dirty_subdomains_) {
    changes.subdomains.push_back(durable_.subdomains.at(key));
  }
  for (const TaskId id : dirty_tasks_) changes.tasks.push_back(durable_.tasks.at(id));
  for (auto& [id, worker] : dirty_workers_) changes.workers.push_back(std::move(worker));
  for (auto& [id, attempt] : dirty_attempts_) changes.attempts.push_back(std::move(attempt));
  for (auto& [name, host] : dirty_hosts_) changes.hosts.push_back(std::move(host));
  changes.events = std::exchange(new_events_, {});
  dirty_jobs_.clear();
  dirty_subdomains_.clear();
  dirty_tasks_.clear();
  dirty_workers_.clear();
  dirty_attempts_.clear();
  dirty_hosts_.clear();
  return changes;
}

std::vector<Command> JobState::take_commands() { return std::exchange(commands_, {}); }

}  // namespace tetfarm
