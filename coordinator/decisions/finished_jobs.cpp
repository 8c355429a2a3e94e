#include "coordinator/decisions/finished_jobs.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <tuple>

#include "base/check.h"
#include "coordinator/decisions/job_status.h"
#include "coordinator/decisions/message_translation.h"
#include "coordinator/decisions/task_reuse.h"

namespace tetfarm {
namespace {

/// Lists of like length become one, so that there are few of them and each entry is moved seldom.
template <class Entry, class ComesBefore>
void merge_into(std::vector<std::vector<Entry>>& lists, std::vector<Entry> list,
                ComesBefore comes_before) {
  std::sort(list.begin(), list.end(), comes_before);
  while (!lists.empty() && lists.back().size() < 2 * list.size()) {
    std::vector<Entry> merged;
    merged.reserve(list.size() + lists.back().size());
    std::merge(list.begin(), list.end(), lists.back().begin(), lists.back().end(),
               std::back_inserter(merged), comes_before);
    list = std::move(merged);
    lists.pop_back();
  }
  if (!list.empty()) lists.push_back(std::move(list));
}

}  // namespace

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
  remember_files(rows);
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

/// A file as often as tasks have it.
std::vector<FileKey> FinishedJobs::files_that_stay(const DurableState& rows) const {
  const JobRow& job = rows.jobs.begin()->second;
  const bool all = job.phase != JobPhase::done || keeps_all(keeps_all_files_, job);
  std::vector<FileKey> files;
  const auto add = [&files](const std::vector<ArtifactRef>& more) {
    for (const ArtifactRef& file : more) files.push_back(file_key(file.hash));
  };
  for (const auto& [id, task] : rows.tasks) {
    if (all || traits_of(task.kind).begins_job) add(task.inputs);
    if (all || stays(task.kind)) add(task.outputs);
  }
  return files;
}

void FinishedJobs::remember_files(const DurableState& rows) {
  const JobRow& job = rows.jobs.begin()->second;
  const bool may_go_on = job.phase != JobPhase::done;
  std::vector<FileKey> files = files_that_stay(rows);
  files_of_others_.erase(job.id);
  if (!may_go_on) return merge_into(files_, std::move(files), std::less<>());
  std::sort(files.begin(), files.end());
  files_of_others_[job.id] = std::move(files);
}

void FinishedJobs::forget(const DurableState& rows) {
  TF_CHECK(rows.jobs.size() == 1);
  const JobRow& job = rows.jobs.begin()->second;
  jobs_.erase(job.id);
  for (std::vector<Work>& list : work_) {
    std::erase_if(list, [&rows](const Work& work) { return rows.tasks.contains(work.task); });
  }
  if (files_of_others_.erase(job.id) > 0) return;
  std::map<FileKey, std::size_t> left;
  for (const FileKey& file : files_that_stay(rows)) ++left[file];
  for (std::vector<FileKey>& list : files_) {
    std::erase_if(list, [&left](const FileKey& file) {
      const auto found = left.find(file);
      if (found == left.end() || found->second == 0) return false;
      --found->second;
      return true;
    });
  }
}

bool FinishedJobs::needs(const std::string& hash, const std::set<JobId>& others) const {
  const auto has = [key = file_key(hash)](const std::vector<FileKey>& list) {
    return std::binary_search(list.begin(), list.end(), key);
  };
  if (std::any_of(files_.begin(), files_.end(), has)) return true;
  return std::any_of(files_of_others_.begin(), files_of_others_.end(), [&](const auto& job) {
    return !others.contains(job.first) && has(job.second);
  });
}

void FinishedJobs::note_leavings(const DurableState& rows,
                                 const std::function<bool(const ArtifactRef&)>& has_file) {
  const JobRow& job = rows.jobs.begin()->second;
  if (!has_file || job.phase != JobPhase::done || keeps_all(keeps_all_files_, job)) return;
  for (const auto& [id, task] : rows.tasks) {
    if (stays(task.kind)) continue;
    for (const ArtifactRef& file : task.outputs) {
      if (has_file(file)) leavings_.push_back(file.hash);
    }
  }
}

void FinishedJobs::put_others_than(const DurableState& unfinished,
                                   const std::function<bool(const ArtifactRef&)>& has_file) {
  std::map<JobId, bool> is_there;
  for (const auto& [id, task] : unfinished.tasks) is_there[task.job] = true;
  for (const auto& [id, job] : unfinished.jobs) {
    if (is_there.contains(id) || contains(id)) continue;
    const DurableState rows = rows_of(id);
    put(rows);
    note_leavings(rows, has_file);
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

void FinishedJobs::remember(std::vector<Work> work) {
  merge_into(work_, std::move(work), comes_before);
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
