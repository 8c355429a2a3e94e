/// JobState, the part about cosmetics across cuts: who may have the next turn.
#include "base/check.h"
#include "coordinator/decisions/cosmetic_graph.h"
#include "coordinator/decisions/job_state.h"
#include "coordinator/decisions/task_rows.h"
#include "tasks/order_contract.h"

namespace tetfarm {

/// A task of which it is known what it made: done, or done once and made again for a lost file, be
/// it that it is in quarantine by now.
const TaskRow* JobState::find_done(JobId job, TaskKind kind, std::uint64_t path) const {
  const TaskRow* task = find_task(job, kind, path);
  if (task == nullptr || task->outputs.empty()) return nullptr;
  return task->state == TaskState::failed && !was_done_before(*task) ? nullptr : task;
}

const TurnOrder& JobState::turns_of(JobId job) {
  if (const TurnOrder* known = progress_.turns(job)) return *known;
  const TaskRow* order = find_done(job, TaskKind::order, 0);
  TF_CHECK(order != nullptr);
  std::optional<TurnOrder> turns = turn_order_of(made_by<OrderMade>(*order).order);
  TF_CHECK(turns.has_value());
  return progress_.set_turns(job, std::move(*turns));
}

void JobState::order_when_whole(JobId job, Moment now) {
  if (progress_.has_open(job)) return;
  const std::vector<SubdomainRow> tree = tree_of(job);
  const TaskRow* inspect = find_task(job, TaskKind::inspect, 0);
  if (has_seam_cosmetics(*inspect, tree)) add_task(order_task(*inspect, tree), now);
}

/// The leaf of that path is meshed, or the order is known: if both, its elements are extracted.
void JobState::extract_when_ordered(JobId job, std::uint64_t leaf, Moment now) {
  const TaskRow* order = find_done(job, TaskKind::order, 0);
  const TaskRow* mesh = find_done(job, TaskKind::mesh, leaf);
  if (order != nullptr && mesh != nullptr) add_task(extract_task(*order, *mesh), now);
}

/// After an extraction or a turn at that leaf: the leaf itself and its neighbours may be next.
void JobState::give_turns_round(JobId job, std::uint64_t leaf, Moment now) {
  const TaskRow* inspect = find_task(job, TaskKind::inspect, 0);
  const TurnOrder& turns = turns_of(job);
  const auto find = [this, job](TaskKind kind, std::uint64_t path) {
    return find_done(job, kind, path);
  };
  std::vector<std::uint64_t> next = turns.at(leaf).neighbours;
  next.push_back(leaf);
  for (const std::uint64_t candidate : next) {
    if (find_task(job, TaskKind::cosmetic, candidate) != nullptr) continue;
    if (const auto task = cosmetic_task(*inspect, turns, candidate, find)) add_task(*task, now);
  }
}

}  // namespace tetfarm
