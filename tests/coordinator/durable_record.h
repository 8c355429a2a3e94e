// A database in memory: takes change sets as JobDatabase does, and checks what SQLite would check.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>

#include "store/rows.h"

namespace tetfarm {

class DurableRecord {
 public:
  void apply(const ChangeSet& changes) {
    for (const JobRow& job : changes.jobs) state_.jobs[job.id] = job;
    for (const SubdomainRow& row : changes.subdomains) {
      state_.subdomains[{row.job, row.path}] = row;
    }
    for (const TaskRow& task : changes.tasks) put(task);
    for (const WorkerRow& worker : changes.workers) {
      state_.last_worker = std::max(state_.last_worker, worker.id.value);
    }
    for (const AttemptRow& attempt : changes.attempts) put(attempt);
    for (const HostRow& host : changes.hosts) {
      state_.quarantined_hosts.erase(host.host);
      if (host.is_quarantined) state_.quarantined_hosts[host.host] = host;
    }
    events_.insert(events_.end(), changes.events.begin(), changes.events.end());
    for (const JobId job : changes.removed_jobs) remove(job);
  }

  const DurableState& state() const { return state_; }

  // What JobDatabase reads of it: load_unfinished, load_job, find_task.
  DurableState unfinished() const {
    std::set<JobId> jobs;
    for (const auto& [id, job] : state_.jobs) {
      if (!is_end(job.phase)) jobs.insert(id);
    }
    for (const auto& [id, attempt] : state_.running_attempts) {
      jobs.insert(state_.tasks.at(attempt.task).job);
    }
    DurableState part = state_;
    std::erase_if(part.tasks, [&](const auto& row) { return !jobs.contains(row.second.job); });
    std::erase_if(part.subdomains, [&](const auto& row) { return !jobs.contains(row.second.job); });
    return part;
  }
  DurableState rows_of(JobId job) const {
    DurableState part;
    part.jobs.emplace(job, state_.jobs.at(job));
    for (const auto& [id, task] : state_.tasks) {
      if (task.job == job) part.tasks.emplace(id, task);
    }
    for (const auto& [key, subdomain] : state_.subdomains) {
      if (key.first == job) part.subdomains.emplace(key, subdomain);
    }
    return part;
  }
  std::optional<TaskRow> row_of(TaskId task) const {
    const auto found = state_.tasks.find(task);
    return found == state_.tasks.end() ? std::nullopt : std::optional(found->second);
  }

  const std::map<AttemptId, AttemptRow>& attempts() const { return attempts_; }
  const std::vector<EventRow>& events() const { return events_; }

 private:
  void remove(JobId job) {
    state_.last_job = std::max(state_.last_job, job.value);
    state_.jobs.erase(job);
    std::erase_if(attempts_, [&](const auto& attempt) {
      return state_.tasks.at(attempt.second.task).job == job;
    });
    std::erase_if(state_.tasks, [&](const auto& task) { return task.second.job == job; });
    std::erase_if(state_.subdomains, [&](const auto& node) { return node.first.first == job; });
    std::erase_if(places_, [&](const auto& place) { return std::get<0>(place.first) == job; });
  }

  void put(const TaskRow& task) {
    const auto old = state_.tasks.find(task.id);
    if (old != state_.tasks.end()) {
      EXPECT_EQ(old->second.kind, task.kind);
      EXPECT_EQ(old->second.path, task.path);
      EXPECT_EQ(old->second.inputs, task.inputs) << "the inputs of a task never change";
      EXPECT_EQ(old->second.parameters, task.parameters) << "nor do its parameters";
    }
    state_.tasks[task.id] = task;
    state_.last_task = std::max(state_.last_task, task.id.value);
    const Place place{task.job, task.kind, task.path};
    const auto there = places_.find(place);
    if (task.state == TaskState::replaced) {
      if (there != places_.end() && there->second == task.id) places_.erase(there);
    } else {
      EXPECT_EQ(places_.emplace(place, task.id).first->second, task.id) << "two tasks in a place";
    }
  }

  void put(const AttemptRow& attempt) {
    const auto old = attempts_.find(attempt.id);
    if (old != attempts_.end()) {
      EXPECT_EQ(old->second.state, AttemptState::running) << "an ended attempt came back";
      EXPECT_EQ(old->second.task, attempt.task);
    }
    attempts_[attempt.id] = attempt;
    state_.last_attempt = std::max(state_.last_attempt, attempt.id.value);
    state_.running_attempts.erase(attempt.id);
    if (attempt.state == AttemptState::running) state_.running_attempts[attempt.id] = attempt;
  }

  using Place = std::tuple<JobId, TaskKind, std::uint64_t>;

  DurableState state_;
  std::map<Place, TaskId> places_;
  std::map<AttemptId, AttemptRow> attempts_;
  std::vector<EventRow> events_;
};

}  // namespace tetfarm
