#include "coordinator/decisions/file_needs.h"

#include "base/check.h"
#include "base/hash.h"
#include "coordinator/decisions/job_state.h"
#include "tasks/task_kind.h"

namespace tetfarm {
namespace {

/// The first stage of a job in which no reader of what the kind makes comes into being any more;
/// of what stays, none does: from an inspection, whose files are small, a job can go on anew.
FileStage last_reader_is_there_at(TaskKind kind) {
  switch (kind) {
    case TaskKind::decompose:  // the rows of sub-domains know better
      return FileStage::growing;
    case TaskKind::assimilate:
    case TaskKind::mesh:
    case TaskKind::order:
    case TaskKind::extract:
    case TaskKind::cosmetic:
      return FileStage::numbered;
    case TaskKind::number:
    case TaskKind::write:
    case TaskKind::grow:
      return FileStage::assembling;
    default:
      return FileStage::over;
  }
}

}  // namespace

bool stays(TaskKind kind) { return last_reader_is_there_at(kind) == FileStage::over; }

bool keeps_all(const KeepsAllFiles& says, const JobRow& job) { return !says || says(job); }

bool needs_inputs(const TaskRow& task, FileStage stage) {
  if (traits_of(task.kind).begins_job || task.state == TaskState::leased) return true;
  if (task.state == TaskState::done || task.state == TaskState::replaced) return false;
  return stage != FileStage::over;
}

bool has_result(const TaskRow& task) {
  if (task.outputs.empty()) return false;
  if (traits_of(task.kind).ends_job) return task.state != TaskState::failed;
  return task.state == TaskState::done || was_done_before(task);
}

bool may_get_readers(const TaskRow& task, FileStage stage) {
  if (task.state == TaskState::replaced || !has_result(task)) return false;
  return stays(task.kind) || stage < last_reader_is_there_at(task.kind);
}

bool may_get_readers(const SubdomainRow& subdomain, FileStage stage) {
  const bool is_alive =
      subdomain.state == SubdomainState::open || subdomain.state == SubdomainState::leaf;
  return is_alive && stage == FileStage::growing;
}

FileKey file_key(const std::string& hash) {
  const Hash128 key = hash128(hash);
  return {key.high, key.low};
}

void FileNeeds::add(const std::vector<ArtifactRef>& files, Counts& counts) {
  for (const ArtifactRef& file : files) ++counts[file_key(file.hash)];
}

void FileNeeds::release(const std::string& hash, bool may_go) {
  const auto count = counts_.find(file_key(hash));
  TF_CHECK(count != counts_.end());
  if (--count->second > 0) return;
  counts_.erase(count);
  if (may_go) doubtful_.insert(hash);
}

void FileNeeds::set(bool& known, bool is_needed, const std::vector<ArtifactRef>& files,
                    bool may_go) {
  if (known == is_needed) return;
  known = is_needed;
  if (is_needed) return add(files, counts_);
  for (const ArtifactRef& file : files) release(file.hash, may_go);
}

bool FileNeeds::update(const TaskRow& task, bool inputs, bool outputs) {
  Needed& known = tasks_[task.id];
  const bool wants_more = inputs && !known.inputs;
  set(known.inputs, inputs, task.inputs, true);
  set(known.outputs, outputs, task.outputs, !stays(task.kind));
  if (!inputs && !outputs) tasks_.erase(task.id);
  if (outputs || stays(task.kind) || !has_result(task)) return wants_more;
  for (const ArtifactRef& file : task.outputs) consider(file.hash);
  return wants_more;
}

void FileNeeds::update(const SubdomainRow& subdomain, bool is_needed) {
  const SubdomainKey key{subdomain.job, subdomain.path};
  const auto known = subdomains_.find(key);
  const bool is_same = known != subdomains_.end() && known->second == subdomain.hash;
  if (is_same && is_needed) return;
  if (is_needed) ++counts_[file_key(subdomain.hash)];
  if (known != subdomains_.end()) {
    release(known->second, true);
    subdomains_.erase(known);
  }
  if (is_needed) subdomains_[key] = subdomain.hash;
}

void FileNeeds::forget(const TaskRow& task) {
  const auto known = tasks_.find(task.id);
  if (known == tasks_.end()) return;
  if (known->second.inputs) {
    for (const ArtifactRef& file : task.inputs) release(file.hash, false);
  }
  if (known->second.outputs) {
    for (const ArtifactRef& file : task.outputs) release(file.hash, false);
  }
  tasks_.erase(known);
}

void FileNeeds::forget(const SubdomainKey& subdomain) {
  const auto known = subdomains_.find(subdomain);
  if (known == subdomains_.end()) return;
  release(known->second, false);
  subdomains_.erase(known);
}

std::vector<std::string> FileNeeds::take_unneeded() {
  std::vector<std::string> unneeded;
  for (const std::string& hash : doubtful_) {
    if (!is_needed(hash)) unneeded.push_back(hash);
  }
  doubtful_.clear();
  return unneeded;
}

std::vector<std::string> FileNeeds::validate(const DurableState& rows) const {
  std::vector<std::string> broken;
  Counts expected;
  for (const auto& [id, needed] : tasks_) {
    const auto task = rows.tasks.find(id);
    if (task == rows.tasks.end()) {
      broken.push_back("task " + std::to_string(id.value) + " is not there, and needs files");
      continue;
    }
    if (needed.inputs) add(task->second.inputs, expected);
    if (needed.outputs) add(task->second.outputs, expected);
  }
  for (const auto& [key, hash] : subdomains_) ++expected[file_key(hash)];
  if (expected != counts_) broken.emplace_back("files are counted wrongly");
  for (const auto& [id, task] : rows.tasks) {
    const auto known = tasks_.find(id);
    const bool is_to_read = task.state == TaskState::waiting || task.state == TaskState::ready ||
                            task.state == TaskState::leased;
    const JobPhase phase = rows.jobs.at(task.job).phase;
    const bool has_inputs = known != tasks_.end() && known->second.inputs;
    if (is_to_read && phase == JobPhase::running && !has_inputs) {
      broken.push_back("task " + std::to_string(id.value) + " is to run, and its inputs may go");
    }
  }
  return broken;
}

}  // namespace tetfarm
