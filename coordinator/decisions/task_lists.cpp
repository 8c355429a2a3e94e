#include "coordinator/decisions/task_lists.h"

#include "tasks/task_kind.h"

namespace tetfarm {
namespace {

TaskLists::Offer offer_of(const TaskRow& task, const JobRow& job) {
  return {-job.priority, traits_of(task.kind).rank, task.id};
}

bool is_on_offer(const TaskRow& task, const JobRow& job) {
  return task.state == TaskState::ready && job.phase == JobPhase::running;
}

bool is_at_work(const TaskRow& task) {
  return task.state == TaskState::ready || task.state == TaskState::leased;
}

void list(const TaskRow& task, bool belongs, TaskLists::OfJobs& lists) {
  if (belongs) {
    lists[task.job].insert(task.id);
    return;
  }
  const auto of_job = lists.find(task.job);
  if (of_job == lists.end()) return;
  of_job->second.erase(task.id);
  if (of_job->second.empty()) lists.erase(of_job);
}

bool is_listed(const TaskRow& task, const TaskLists::OfJobs& lists) {
  const auto of_job = lists.find(task.job);
  return of_job != lists.end() && of_job->second.contains(task.id);
}

std::size_t count_of(const TaskLists::OfJobs& lists) {
  std::size_t count = 0;
  for (const auto& [job, tasks] : lists) count += tasks.size();
  return count;
}

}  // namespace

void TaskLists::place(const TaskRow& task) { places_[{task.job, task.kind, task.path}] = task.id; }

void TaskLists::unplace(const TaskRow& task) { places_.erase({task.job, task.kind, task.path}); }

void TaskLists::offer(const TaskRow& task, const JobRow& job) {
  offers_.insert(offer_of(task, job));
  offers_of_users_[job.owner].insert(offer_of(task, job));
}

/// Whether it was on offer.
bool TaskLists::withdraw(const TaskRow& task, const JobRow& job) {
  if (offers_.erase(offer_of(task, job)) == 0) return false;
  const auto of_user = offers_of_users_.find(job.owner);
  of_user->second.erase(offer_of(task, job));
  if (of_user->second.empty()) offers_of_users_.erase(of_user);
  return true;
}

void TaskLists::update(const TaskRow& task, const JobRow& job) {
  if (is_on_offer(task, job)) {
    offer(task, job);
  } else {
    withdraw(task, job);
  }
  list(task, is_at_work(task), active_);
  list(task, task.state == TaskState::failed, failed_);
}

void TaskLists::move(const std::map<TaskId, TaskRow>& tasks, JobRow& job, int priority) {
  std::vector<TaskId> offered;
  if (const auto found = active_.find(job.id); found != active_.end()) {
    for (const TaskId id : found->second) {
      if (withdraw(tasks.at(id), job)) offered.push_back(id);
    }
  }
  job.priority = priority;
  for (const TaskId id : offered) offer(tasks.at(id), job);
}

void TaskLists::forget(JobId job) {
  places_.erase(places_.lower_bound({job, all_task_kinds.front(), 0}),
                places_.lower_bound({JobId{job.value + 1}, all_task_kinds.front(), 0}));
  active_.erase(job);
  failed_.erase(job);
}

std::optional<TaskId> TaskLists::find(JobId job, TaskKind kind, std::uint64_t path) const {
  const auto found = places_.find({job, kind, path});
  return found == places_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<TaskId> TaskLists::tasks_of(JobId job) const {
  std::vector<TaskId> tasks;
  for (auto place = places_.lower_bound({job, all_task_kinds.front(), 0});
       place != places_.end() && std::get<JobId>(place->first) == job; ++place) {
    tasks.push_back(place->second);
  }
  return tasks;
}

std::set<TaskId> TaskLists::failed_of(JobId job) const {
  const auto found = failed_.find(job);
  return found == failed_.end() ? std::set<TaskId>{} : found->second;
}

void TaskLists::find_unlisted(const TaskRow& task, const JobRow& job,
                              std::vector<std::string>& broken) const {
  const auto report = [&broken, &task](const char* what) {
    broken.push_back("task " + std::to_string(task.id.value) + ": " + what);
  };
  const bool is_offered = offers_.contains(offer_of(task, job));
  const auto of_user = offers_of_users_.find(job.owner);
  const bool is_users =
      of_user != offers_of_users_.end() && of_user->second.contains(offer_of(task, job));
  if (is_offered != is_on_offer(task, job) || is_users != is_offered) {
    report("wrongly on offer or not on offer");
  }
  if (is_listed(task, active_) != is_at_work(task)) report("wrongly listed as active, or not");
  const bool has_failed = task.state == TaskState::failed;
  if (is_listed(task, failed_) != has_failed) report("wrongly listed as failed, or not");
  const bool has_place = find(task.job, task.kind, task.path) == task.id;
  if (has_place == (task.state == TaskState::replaced)) {
    report("has no place, or was replaced and has one");
  }
}

std::vector<std::string> TaskLists::validate(const std::map<TaskId, TaskRow>& tasks,
                                             const std::map<JobId, JobRow>& jobs) const {
  std::vector<std::string> broken;
  std::size_t offered = 0;
  std::size_t active = 0;
  std::size_t failed = 0;
  std::size_t placed = 0;
  for (const auto& [id, task] : tasks) {
    const JobRow& job = jobs.at(task.job);
    find_unlisted(task, job, broken);
    if (is_on_offer(task, job)) ++offered;
    if (is_at_work(task)) ++active;
    if (task.state == TaskState::failed) ++failed;
    if (task.state != TaskState::replaced) ++placed;
  }
  std::size_t of_users = 0;
  for (const auto& [user, tasks_of_user] : offers_of_users_) of_users += tasks_of_user.size();
  if (offers_.size() != offered || of_users != offered)
    broken.emplace_back("a task on offer that does not exist");
  if (count_of(active_) != active) broken.emplace_back("an active task that does not exist");
  if (count_of(failed_) != failed) broken.emplace_back("a failed task that does not exist");
  if (places_.size() != placed) broken.emplace_back("a place of a task that does not exist");
  return broken;
}

}  // namespace tetfarm
