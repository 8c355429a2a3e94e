/// Which files of the store some task needs or may still need, and which nobody needs any more.
///
/// A file is needed by a task that is still to run, or that runs, as one of its inputs; by tasks
/// that are not there yet, to which the graph may give it (task_graph.h): a sub-domain as long as
/// it may be cut, meshed or written, and what a kind makes until the last of its readers has come
/// into being; and for good where it came with the job, is a result of it, or was found out about
/// its surface. Files are known by their hashes: several tasks, also of several jobs, may have the
/// same, which stays until none of them needs it.
///
/// What is removed can be made again: its maker runs again, and where the inputs of that one are
/// gone, so do theirs, down to what came with the job (job_repair.cpp).
///
/// Invariants, checked by validate(): each file is counted once for each that needs it.
/// Cost: O(files of the task · log files) each. Memory: about 64 bytes for each file that is
/// needed.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "store/rows.h"

namespace tetfarm {

/// How far a job is, for its files.
enum class FileStage {
  growing,     ///< leaves are cut, meshed and mended
  numbered,    ///< the nodes have numbers; all tasks that write are there
  assembling,  ///< all tasks are there
  over         ///< it is done
};

/// Whether the task is still to read its inputs, or they came with its job.
bool needs_inputs(const TaskRow& task, FileStage stage);
/// Whether what the task made may be given to tasks that are not there yet, or stays for good.
bool may_get_readers(const TaskRow& task, FileStage stage);
/// The same of a sub-domain's own file.
bool may_get_readers(const SubdomainRow& subdomain, FileStage stage);
/// Whether what the kind makes stays as long as its job: results, what was found out about a
/// surface, and all of loops.
bool stays(TaskKind kind);
/// Whether the outputs are those of a result; otherwise they are none, or evidence of a failure.
bool has_result(const TaskRow& task);

/// A file by its hash.
using FileKey = std::pair<std::uint64_t, std::uint64_t>;
FileKey file_key(const std::string& hash);

/// Whether the job keeps all files between its tasks.
using KeepsAllFiles = std::function<bool(const JobRow&)>;
/// The same where that may not be said: then it does.
bool keeps_all(const KeepsAllFiles& says, const JobRow& job);

class FileNeeds {
 public:
  /// What the task needs now. What it needs no longer, and what it made and nobody needs, may go.
  /// Whether it needs inputs that it did not need before.
  bool update(const TaskRow& task, bool inputs, bool outputs);
  /// The sub-domain's file is needed for itself, or is not.
  void update(const SubdomainRow& subdomain, bool is_needed);
  /// The row leaves memory: it needs nothing, and nothing of it goes.
  void forget(const TaskRow& task);
  void forget(const SubdomainKey& subdomain);

  /// May go if nobody needs it.
  void consider(const std::string& hash) { doubtful_.insert(hash); }

  bool is_needed(const std::string& hash) const { return counts_.contains(file_key(hash)); }
  /// The hashes of those that may go and that nobody needs now, each once, by hash.
  std::vector<std::string> take_unneeded();

  /// The broken invariants, in words; empty when all is well. Cost: O(all).
  std::vector<std::string> validate(const DurableState& rows) const;

 private:
  struct Needed {
    bool inputs = false;
    bool outputs = false;
  };
  using Counts = std::map<FileKey, std::uint32_t>;

  static void add(const std::vector<ArtifactRef>& files, Counts& counts);
  void release(const std::string& hash, bool may_go);
  void set(bool& known, bool is_needed, const std::vector<ArtifactRef>& files, bool may_go);

  Counts counts_;
  std::map<TaskId, Needed> tasks_;                  ///< that need anything
  std::map<SubdomainKey, std::string> subdomains_;  ///< whose files are needed: hashes
  std::set<std::string> doubtful_;
};

}  // namespace tetfarm
