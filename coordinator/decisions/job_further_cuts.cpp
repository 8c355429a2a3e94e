/// JobState, the part about leaves that are out of memory on every worker: they are cut once more.
///
/// The tree grows by a cut, so that everything that depends on the whole tree starts anew: the
/// order of turns, the elements near cuts and the turns themselves. Their tasks are replaced: they
/// stay as rows, for people, and others have their places. The job ends as if it had had that tree
/// from the start: same tree, same mesh. Which leaves are cut depends on the memory of the workers.

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
  const std::uint32_t cuts = progress_.former_leaves_above(job, task.path);
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
  changes_.add(
      {now.wall_ms, job, mesh.id, {}, {}, "cut further", std::to_string(leaf) + ": " + why});
  carry_out(step, now);
}

/// What was decided and done from the whole tree.
void JobState::replace_turns(JobId job, const std::string& why, Moment now) {
  for (const TaskId id : lists_.tasks_of(job)) {
    if (traits_of(durable_.tasks.at(id).kind).needs_whole_tree) replace(id, why, now);
  }
  progress_.start_turns_anew(job);
}

void JobState::replace(TaskId id, const std::string& why, Moment now) {
  TaskRow& task = edit(id);
  revoke_attempts(task, why, now);
  lists_.unplace(task);
  delays_.forget(id);
  task.message = why;
  task.attempt = {};
  set_state(task, TaskState::replaced);
  note_replaced(task);
  record(now, task, {}, {}, "replaced", why);
}

/// A mesh is replaced only when its own leaf is cut.
void JobState::note_replaced(const TaskRow& task) {
  if (task.kind == TaskKind::mesh) progress_.note_former_leaf(task.job, task.path);
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
