/// What is known at once of jobs that have ended; their rows stay in the database and are read when
/// somebody asks for them.
///
/// Kept of each: its status, its result files, how many tasks there are, and under which names its
/// work may serve later jobs: 24 bytes a task. Only what was committed is put here, so it stays
/// valid when decisions that could not be committed are thrown away. A job that goes on again is in
/// the hands of JobState, whose rows count then.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/hash.h"
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
  explicit FinishedJobs(Rows rows) : rows_(std::move(rows)) {}
  bool is_kept() const { return rows_.of_job != nullptr; }

  /// @pre `rows` are committed and those of one job, which has ended.
  /// Cost: O(tasks and what they read), and now and then O(all tasks).
  void put(const DurableState& rows);
  /// Puts each job whose rows are neither here nor in `unfinished`. Cost: reads them.
  void put_others_than(const DurableState& unfinished);

  bool contains(JobId job) const { return jobs_.contains(job); }
  const std::map<JobId, FinishedJob>& jobs() const { return jobs_; }
  /// @throws as reading.
  DurableState rows_of(JobId job) const { return rows_.of_job(job); }
  /// Of any job; nothing when there is no such task. @throws as reading.
  std::optional<TaskRow> task(TaskId task) const;

  /// Tasks that did work of that key, see task_reuse.h. Cost: O(log²(tasks)).
  std::vector<TaskId> did(const Hash128& work) const;
  /// Learnt from all of them.
  const TaskExpectation& expectation() const { return expectation_; }

 private:
  struct Work {
    Hash128 key;
    TaskId task;
  };
  static bool comes_before(const Work& a, const Work& b);
  void remember(std::vector<Work> work);

  Rows rows_;
  std::map<JobId, FinishedJob> jobs_;
  /// Each sorted, and less than half as long as the one before it.
  std::vector<std::vector<Work>> work_;
  TaskExpectation expectation_;
};

/// Those of a database. @pre it outlives them.
FinishedJobs::Rows rows_in(const JobDatabase& database);

}  // namespace tetfarm
