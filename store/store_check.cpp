#include "store/store_check.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/file_system.h"

namespace tetfarm {
namespace {

using FileKey = std::pair<JobId, std::string>;  ///< a file as a job knows it

/// Walks the rows once to see who makes and reads what, then follows what is damaged.
class StoreCheck {
 public:
  StoreCheck(const DurableState& state, const LookAtFile& look, const KeepsAll& keeps_all)
      : state_(state), look_(look) {
    if (!keeps_all) return;
    for (const auto& [id, job] : state.jobs) {
      if (!keeps_all(job)) removes_.insert(id);
    }
  }

  StoreReport run() {
    for (const auto& [id, task] : state_.tasks) {
      if (task.state != TaskState::replaced) note(task);
    }
    for (const auto& [id, task] : state_.tasks) {
      if (task.state == TaskState::replaced) continue;
      const JobPhase phase = state_.jobs.at(task.job).phase;
      const bool is_to_run = !is_end(phase) && task.state != TaskState::done;
      const bool has_results = phase == JobPhase::done && traits_of(task.kind).ends_job;
      if (is_to_run) need(task.job, task.inputs);
      if (has_results) need(task.job, task.outputs);
    }
    forget_what_was_removed();
    report_.redone.assign(redone_.begin(), redone_.end());
    report_.hopeless.assign(hopeless_.begin(), hopeless_.end());
    for (auto& [hash, file] : damaged_) report_.damaged.push_back(std::move(file));
    return std::move(report_);
  }

 private:
  void note(const TaskRow& task) {
    for (const ArtifactRef& file : task.outputs) {
      makers_[{task.job, file.hash}].push_back(task.id);
      if (look_once(file)) damaged_.at(file.hash).makers.push_back(task.id);
    }
    for (const ArtifactRef& file : task.inputs) {
      look_once(file);
      if (task.state == TaskState::done) was_read_.insert(file.hash);
    }
  }

  void forget_what_was_removed() {
    report_.gone = std::erase_if(damaged_, [this](const auto& entry) {
      const auto& [hash, file] = entry;
      const bool may_go = !file.makers.empty() &&
                          std::all_of(file.makers.begin(), file.makers.end(), [this](TaskId maker) {
                            return removes_.contains(state_.tasks.at(maker).job);
                          });
      return may_go && file.state == FileState::missing && !file.is_needed &&
             was_read_.contains(hash);
    });
  }

  /// Whether it is damaged.
  bool look_once(const ArtifactRef& file) {
    if (!seen_.insert(file.hash).second) return damaged_.contains(file.hash);
    ++report_.files;
    const FileState found = look_(file);
    if (found == FileState::sound) return false;
    damaged_[file.hash] = {file, found, {}, false};
    return true;
  }

  void need(JobId job, const std::vector<ArtifactRef>& files) {
    for (const ArtifactRef& file : files) {
      const auto damaged = damaged_.find(file.hash);
      if (damaged == damaged_.end()) continue;
      damaged->second.is_needed = true;
      const auto makers = makers_.find({job, file.hash});
      if (makers == makers_.end()) hopeless_.insert(job);
      if (makers == makers_.end()) continue;
      for (const TaskId maker : makers->second) {
        if (redone_.insert(maker).second) need(job, state_.tasks.at(maker).inputs);
      }
    }
  }

  const DurableState& state_;
  const LookAtFile& look_;
  StoreReport report_;
  std::set<std::string> seen_;
  std::set<std::string> was_read_;  ///< by a task that is done
  std::map<std::string, DamagedFile> damaged_;
  std::map<FileKey, std::vector<TaskId>> makers_;
  std::set<TaskId> redone_;
  std::set<JobId> hopeless_;
  std::set<JobId> removes_;  ///< that do not keep all
};

}  // namespace

LookAtFile look_into(const ArtifactStore& store, bool checksums) {
  return [&store, checksums](const ArtifactRef& file) {
    if (!ArtifactStore::is_hash(file.hash)) return FileState::wrong_bytes;
    const std::optional<std::uint64_t> size = size_of_file(store.path_of(file.hash));
    if (!size) return FileState::missing;
    if (*size != file.size) return FileState::wrong_size;
    if (!checksums) return FileState::sound;
    try {
      store.verify(file.hash, file.size);
      return FileState::sound;
    } catch (const CorruptFile&) {
      return FileState::wrong_bytes;
    }
  };
}

StoreReport check_store(const DurableState& state, const LookAtFile& look,
                        const KeepsAll& keeps_all) {
  return StoreCheck(state, look, keeps_all).run();
}

const char* name_of(FileState state) {
  switch (state) {
    case FileState::sound:
      return "sound";
    case FileState::missing:
      return "missing";
    case FileState::wrong_size:
      return "of another size";
    case FileState::wrong_bytes:
      return "with a wrong checksum";
  }
  return "unknown";
}

}  // namespace tetfarm
