/// JobState, the part about jobs that have ended: their rows leave memory, and come back when the
/// job goes on.
#include <utility>

#include "base/check.h"
#include "coordinator/decisions/job_state.h"
#include "coordinator/decisions/task_reuse.h"
#include "coordinator/decisions/task_rows.h"
#include "tasks/cosmetic_contract.h"
#include "tasks/grow_contract.h"
#include "tasks/inspect_contract.h"
#include "tasks/write_contract.h"

namespace tetfarm {

/// What is found out from a row alone.
void JobState::take_in(const TaskRow& task) {
  at_hand_.insert(task.job);
  if (task.state == TaskState::replaced) {
    note_replaced(task);
    note_files(task, files_of(task.job));
    return;
  }
  lists_.place(task);
  index(task);
  const bool had_turn =
      task.kind == TaskKind::cosmetic && !made_by<CosmeticMade>(task).elements.hash.empty();
  if (had_turn) progress_.note_turn_over(task.job);
  const bool is_written =
      (task.kind == TaskKind::write && !made_by<WriteMade>(task).portion.hash.empty()) ||
      (task.kind == TaskKind::grow && !made_by<GrowMade>(task).portion.hash.empty());
  if (is_written) progress_.note_written(task.job);
  if (task.kind == TaskKind::inspect) {
    progress_.set_chunks(task.job, made_by<InspectMade>(task).layers.size());
  }
  remember_work(task);
}

/// Before anything of a job that may have ended is decided. Nothing happens to one that is here.
void JobState::bring_back(JobId job) {
  if (is_at_hand(job) || !finished_->contains(job)) return;
  DurableState rows = finished_->rows_of(job);
  for (const auto& [key, subdomain] : rows.subdomains) progress_.add(subdomain);
  durable_.subdomains.merge(rows.subdomains);
  for (auto& [id, row] : rows.tasks) {
    take_in(durable_.tasks.insert_or_assign(id, std::move(row)).first->second);
  }
  note_files_of_tree(job);
}

std::vector<DurableState> JobState::take_finished() {
  std::vector<DurableState> taken;
  if (!finished_->is_kept()) return taken;
  TF_CHECK(changes_.has_no_job_rows());
  std::set<JobId> over;
  for (const JobId job : at_hand_) {
    if (is_end(durable_.jobs.at(job).phase)) over.insert(job);
  }
  if (over.empty()) return taken;
  for (const auto& [id, attempt] : durable_.running_attempts) {
    over.erase(durable_.tasks.at(attempt.task).job);
  }
  for (const JobId job : over) taken.push_back(take_out(job));
  return taken;
}

DurableState JobState::take_out(JobId job) {
  DurableState rows;
  rows.jobs.emplace(job, durable_.jobs.at(job));
  for (auto next = durable_.tasks.begin(); next != durable_.tasks.end();) {
    const auto task = next++;
    if (task->second.job != job) continue;
    const Hash128 key = work_key(task->second, program_of(task->second));
    const auto work = done_work_.find({key.high, key.low});
    if (work != done_work_.end()) work->second.erase(task->first);
    if (work != done_work_.end() && work->second.empty()) done_work_.erase(work);
    delays_.forget(task->first);
    file_needs_.forget(task->second);
    rows.tasks.insert(durable_.tasks.extract(task));
  }
  const auto end = durable_.subdomains.lower_bound({JobId{job.value + 1}, 0});
  for (auto next = durable_.subdomains.lower_bound({job, 0}); next != end;) {
    file_needs_.forget(next->first);
    rows.subdomains.insert(durable_.subdomains.extract(next++));
  }
  lists_.forget(job);
  progress_.forget(job);
  files_of_jobs_.erase(job);
  at_hand_.erase(job);
  return rows;
}

}  // namespace tetfarm
