#include "coordinator/decisions/finished_jobs.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "base/check.h"
#include "coordinator/decisions/job_status.h"
#include "coordinator/decisions/message_translation.h"
#include "coordinator/decisions/task_reuse.h"

namespace tetfarm {

void FinishedJobs::put(const DurableState& rows) {
  TF_CHECK(rows.jobs.size() == 1);
  const JobRow& job = rows.jobs.begin()->second;
  const JobSummary summary = summary_of(rows, job, "", job.finished_ms);
  FinishedJob& finished = jobs_[job.id];
  finished = {};
  finished.status = status_message(summary).SerializeAsString();
  if (job.phase == JobPhase::done) finished.results = summary.files;
  finished.peak_rss_bytes = summary.peak_rss_bytes_worker;
  std::vector<Work> work;
  for (const auto& [id, task] : rows.tasks) {
    ++finished.tasks[{task.kind, task.state}];
    if (task.state != TaskState::done) continue;
    const Hash128 key = work_key(task, program_of(task));
    const std::vector<TaskId> known = did(key);
    if (std::find(known.begin(), known.end(), id) == known.end()) work.push_back({key, id});
  }
  remember(std::move(work));
  // Of each kind no more than are remembered.
  std::map<TaskKind, std::uint64_t> left;
  for (const auto& [what, count] : finished.tasks) {
    if (what.second == TaskState::done) left[what.first] = count;
  }
  for (const auto& [id, task] : rows.tasks) {
    if (task.state != TaskState::done) continue;
    if (left[task.kind]-- <= TaskExpectation::samples_kept) expectation_.learn(task);
  }
}

void FinishedJobs::put_others_than(const DurableState& unfinished) {
  std::map<JobId, bool> is_there;
  for (const auto& [id, task] : unfinished.tasks) is_there[task.job] = true;
  for (const auto& [id, job] : unfinished.jobs) {
    if (!is_there.contains(id) && !contains(id)) put(rows_of(id));
  }
}

FinishedJobs::Rows rows_in(const JobDatabase& database) {
  return {[&database](JobId job) { return database.load_job(job); },
          [&database](TaskId task) { return database.find_task(task); }};
}

std::optional<TaskRow> FinishedJobs::task(TaskId task) const {
  if (!is_kept()) return std::nullopt;
  return rows_.of_task(task);
}

bool FinishedJobs::comes_before(const Work& a, const Work& b) {
  return std::tie(a.key.high, a.key.low, a.task) < std::tie(b.key.high, b.key.low, b.task);
}

/// Lists of like length become one, so that there are few of them and each task is moved seldom.
void FinishedJobs::remember(std::vector<Work> work) {
  std::sort(work.begin(), work.end(), comes_before);
  while (!work_.empty() && work_.back().size() < 2 * work.size()) {
    std::vector<Work> merged;
    merged.reserve(work.size() + work_.back().size());
    std::merge(work.begin(), work.end(), work_.back().begin(), work_.back().end(),
               std::back_inserter(merged), comes_before);
    work = std::move(merged);
    work_.pop_back();
  }
  if (!work.empty()) work_.push_back(std::move(work));
}

std::vector<TaskId> FinishedJobs::did(const Hash128& work) const {
  std::vector<TaskId> tasks;
  for (const std::vector<Work>& list : work_) {
    auto found = std::lower_bound(list.begin(), list.end(), Work{work, {}}, comes_before);
    for (; found != list.end() && found->key == work; ++found) tasks.push_back(found->task);
  }
  return tasks;
}

}  // namespace tetfarm
