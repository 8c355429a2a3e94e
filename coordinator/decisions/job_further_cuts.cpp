/// JobState, the part about leaves that are out of memory on every worker: they are cut once more.
///
/// The tree grows by a cut, so that everything that depends on the whole tree starts anew: the
/// order of turns, the elements near cuts and the turns themselves. Their tasks are replaced: they
/// stay as rows, for people, and others have their places. The job ends as if it had had that tree
/// from the start: same tree, same mesh. Which leaves are cut depends on the memory of the workers.
#include <algorithm>

#include "base/counted.h"
#include "coordinator/decisions/job_state.h"
#include "tasks/task_kind.h"

namespace tetfarm {

/// Whether the leaf of this task can be cut once more; "" when it can, else why not.
std::string JobState::why_no_further_cut(const TaskRow& task) const {
  if (!traits_of(task.kind).shrinks_with_leaf) return "more cuts do not make it smaller";
  const JobId job = task.job;
  if (find_task(job, TaskKind::number, 0) != nullptr) return "the nodes are already numbered";
  if (task.path >= deepest_cut) return "the tree cannot be deeper";
  if (find_task(job, TaskKind::decompose, task.path) != nullptr) {
    return "its sub-domain cannot be cut";
  }
  const std::uint32_t cuts = further_cuts_above(job, task.path);
  if (cuts >= rules_.max_further_cuts) {
    return "it was already cut further " + counted(cuts, "time");
  }
  for (auto node = durable_.subdomains.lower_bound({job, 0});
       node != durable_.subdomains.end() && node->first.first == job; ++node) {
    if (node->second.joined_into == task.path) return "it is a group of joined leaves";
  }
  return {};
}

/// @pre why_no_further_cut of a task of the leaf is "". The cut is given `room_bytes`.
void JobState::cut_further(JobId job, std::uint64_t leaf, const std::string& why,
                           std::uint64_t room_bytes, Moment now) {
  replace_turns(job, "sub-domain " + std::to_string(leaf) + " is cut further", now);
  const TaskRow& mesh = *find_task(job, TaskKind::mesh, leaf);
  replace(mesh.id, why, now);
  const TaskRow& inspect = *find_task(job, TaskKind::inspect, 0);
  GraphStep step = cut_once_more(inspect, durable_.subdomains.at({job, leaf}));
  for (TaskRow& cut : step.tasks) cut.memory_bytes = room_bytes;
  new_events_.push_back(
      {now.wall_ms, job, mesh.id, {}, {}, "cut further", std::to_string(leaf) + ": " + why});
  carry_out(step, now);
}

/// What was decided and done from the whole tree.
void JobState::replace_turns(JobId job, const std::string& why, Moment now) {
  for (const TaskId id : tasks_of(job)) {
    if (traits_of(durable_.tasks.at(id).kind).needs_whole_tree) replace(id, why, now);
  }
  turns_.erase(job);
  turns_over_.erase(job);
}

void JobState::replace(TaskId id, const std::string& why, Moment now) {
  TaskRow& task = edit(id);
  revoke_attempts(task, why, now);
  places_.erase({task.job, task.kind, task.path});
  not_before_ms_.erase(id);
  failed_on_.erase(id);
  task.message = why;
  task.attempt = {};
  set_state(task, TaskState::replaced);
  note_replaced(task);
  record(now, task, {}, {}, "replaced", why);
}

/// A mesh is replaced only when its own leaf is cut.
void JobState::note_replaced(const TaskRow& task) {
  if (task.kind == TaskKind::mesh) cut_further_[task.job].insert(task.path);
}

/// How many of those that the sub-domain lies below were leaves once.
std::uint32_t JobState::further_cuts_above(JobId job, std::uint64_t path) const {
  const auto paths = cut_further_.find(job);
  if (paths == cut_further_.end()) return 0;
  std::uint32_t cuts = 0;
  for (std::uint64_t above = path / 2; above > 0; above /= 2) {
    if (paths->second.contains(above)) ++cuts;
  }
  return cuts;
}

/// Why the sub-domain is cut, where that was not planned; "" otherwise.
std::string JobState::why_cut_further(JobId job, std::uint64_t path) const {
  for (const auto& [id, task] : durable_.tasks) {
    const bool was_leaf = task.state == TaskState::replaced && task.kind == TaskKind::mesh &&
                          task.job == job && task.path == path;
    if (was_leaf) return task.message;
  }
  return {};
}

}  // namespace tetfarm
