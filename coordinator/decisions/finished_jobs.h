/// What is known at once of jobs that have ended; their rows stay in the database and are read when
/// somebody asks for them.
///
/// Kept of each: its status, its result files, how many tasks there are, under which names its
/// work may serve later jobs: 24 bytes a task, and which files of it stay: 16 bytes each. Only what
/// was committed is put here, so it stays valid when decisions that could not be committed are
/// thrown away. A job that goes on again is in the hands of JobState, whose rows count then.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/hash.h"
#include "coordinator/decisions/file_needs.h"
#include "coordinator/decisions/task_expectation.h"
#include "store/job_database.h"
#include "store/rows.h"

namespace tetfarm {

struct FinishedJob {
  std::string status;                ///< a wire::JobStatus, in its bytes
  std::vector<ArtifactRef> results;  ///< of a done job
  std::map<std::pair<TaskKind, TaskState>, std::uint64_t> tasks;
  std::uint64_t peak_rss_bytes = 0;
};

class FinishedJobs {
 public:
  /// How rows are read. @throws what reading throws: IoError, CorruptFile.
  struct Rows {
    std::function<DurableState(JobId)> of_job;
    std::function<std::optional<TaskRow>(TaskId)> of_task;
  };

  /// Knows of none and will never hear of any: all jobs stay where they are.
  FinishedJobs() = default;
  explicit FinishedJobs(Rows rows, KeepsAllFiles keeps_all_files = {})
      : rows_(std::move(rows)), keeps_all_files_(std::move(keeps_all_files)) {}
  bool is_kept() const { return rows_.of_job != nullptr; }

  /// @pre `rows` are committed and those of one job, which has ended.
  /// Cost: O(tasks and what they read), and now and then O(all tasks).
  void put(const DurableState& rows);
  /// Puts each job whose rows are neither here nor in `unfinished`, and notes which files of them
  /// that need not be there are. Cost: reads them, and looks for the files of those that do not
  /// keep all.
  void put_others_than(const DurableState& unfinished,
                       const std::function<bool(const ArtifactRef&)>& has_file = {});

  /// As if it had never been. @pre `rows` are those with which it was put, and committed as
  /// removed. Cost: O(all tasks and files).
  void forget(const DurableState& rows);

  bool contains(JobId job) const { return jobs_.contains(job); }
  const std::map<JobId, FinishedJob>& jobs() const { return jobs_; }
  /// @throws as reading.
  DurableState rows_of(JobId job) const { return rows_.of_job(job); }
  /// Of any job; nothing when there is no such task. @throws as reading.
  std::optional<TaskRow> task(TaskId task) const;

  /// Tasks that did work of that key, see task_reuse.h. Cost: O(log²(tasks)).
  std::vector<TaskId> did(const Hash128& work) const;
  /// Whether the file stays for one of them: results and what came with the job; all that it has
  /// where it keeps all, or may go on. `others`: jobs that went on already, and are not asked.
  /// Cost: O(log²(files)), and O(log files) for each job that failed or was cancelled.
  bool needs(const std::string& hash, const std::set<JobId>& others) const;
  /// Files that put_others_than found: whoever removed them was ended before. By hash; once.
  std::vector<std::string> take_leavings() { return std::exchange(leavings_, {}); }

  /// Learnt from all of them.
  const TaskExpectation& expectation() const { return expectation_; }

 private:
  struct Work {
    Hash128 key;
    TaskId task;
  };
  static bool comes_before(const Work& a, const Work& b);
  void remember(std::vector<Work> work);
  void remember_files(const DurableState& rows);
  std::vector<FileKey> files_that_stay(const DurableState& rows) const;
  void note_leavings(const DurableState& rows,
                     const std::function<bool(const ArtifactRef&)>& has_file);

  Rows rows_;
  KeepsAllFiles keeps_all_files_;
  std::map<JobId, FinishedJob> jobs_;
  /// Each sorted, and less than half as long as the one before it.
  std::vector<std::vector<Work>> work_;
  std::vector<std::vector<FileKey>> files_;  ///< that stay for jobs that are done, likewise
  std::map<JobId, std::vector<FileKey>> files_of_others_;  ///< that may go on; sorted
  std::vector<std::string> leavings_;
  TaskExpectation expectation_;
};

/// Those of a database. @pre it outlives them.
FinishedJobs::Rows rows_in(const JobDatabase& database);

}  // namespace tetfarm
