/// Which task has which place in the graph, which are on offer, at work, or in quarantine: what is
/// asked for at every turn is found here without a look at every row.
///
/// Whoever changes the state of a task, or the phase of its job, says so. Invariants, checked by
/// validate():
///  1. A task is on offer exactly when it is ready and its job is running.
///  2. A task is listed as active exactly when it is ready or leased, as failed exactly when it is
///  in quarantine.
///  3. A place has one task; those that were replaced have none.
/// Cost: O(log tasks), where it is not said.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "store/rows.h"

namespace tetfarm {

class TaskLists {
 public:
  /// What comes first is handed out first: a job's priority with its sign turned, the rank of the
  /// task's kind, the task.
  using Offer = std::tuple<int, int, TaskId>;
  using OfJobs = std::map<JobId, std::set<TaskId>>;
  /// By the owner of the job; nobody is named who has none.
  using OfUsers = std::map<std::string, std::set<Offer>>;

  /// The task takes its place; who had it has none any more, which validate() tells.
  void place(const TaskRow& task);
  /// Its place is free again.
  void unplace(const TaskRow& task);
  /// The task's state, or its job's phase, may have changed; its job's priority not.
  void update(const TaskRow& task, const JobRow& job);
  /// The job's priority changes: its tasks that are on offer get another place among them.
  void move(const std::map<TaskId, TaskRow>& tasks, JobRow& job, int priority);
  /// All of a job. @pre it is not running.
  void forget(JobId job);

  std::optional<TaskId> find(JobId job, TaskKind kind, std::uint64_t path) const;
  /// Those that have a place, kind by kind, by path. Cost: O(log tasks + tasks of the job).
  std::vector<TaskId> tasks_of(JobId job) const;
  /// In the order in which they are handed out where all are one user's.
  const std::set<Offer>& offers() const { return offers_; }
  /// The same, user by user; see fair_turns.h.
  const OfUsers& offers_of_users() const { return offers_of_users_; }
  /// Whether some task of the job is ready or leased.
  bool is_active(JobId job) const { return active_.contains(job); }
  /// Jobs with tasks in quarantine.
  const OfJobs& failed() const { return failed_; }
  std::set<TaskId> failed_of(JobId job) const;

  /// The broken invariants, in words; empty when all is well. Cost: O(tasks).
  std::vector<std::string> validate(const std::map<TaskId, TaskRow>& tasks,
                                    const std::map<JobId, JobRow>& jobs) const;

 private:
  using Place = std::tuple<JobId, TaskKind, std::uint64_t>;

  void offer(const TaskRow& task, const JobRow& job);
  bool withdraw(const TaskRow& task, const JobRow& job);
  void find_unlisted(const TaskRow& task, const JobRow& job,
                     std::vector<std::string>& broken) const;

  std::map<Place, TaskId> places_;
  std::set<Offer> offers_;
  OfUsers offers_of_users_;
  OfJobs active_;
  OfJobs failed_;
};

}  // namespace tetfarm
