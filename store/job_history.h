/// What happened, read for people: events, every attempt with its log, every worker; and the tasks
/// of jobs that have ended.
///
/// No decision depends on any of this; it is read page by page, so that no answer grows without
/// bound. Units: milliseconds since 1970, bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "store/rows.h"

struct sqlite3;

namespace tetfarm {

/// An event with its place in history: ids rise.
struct PastEvent {
  std::uint64_t id = 0;
  EventRow row;
};

/// Which events; 0 stands for any. By rising id, unless `newest`: then the last ones, also rising.
struct EventFilter {
  JobId job = {};
  TaskId task = {};
  std::uint64_t after = 0;  ///< only ids above it
  std::size_t limit = 1000;
  bool newest = false;
};

/// What a worker did, counted from its attempts.
struct WorkerRecord {
  WorkerRow row;
  std::uint64_t done = 0;
  std::uint64_t not_done = 0;  ///< ended otherwise
  double busy_seconds = 0;     ///< in attempts that have ended
};

class JobHistory {
 public:
  /// @pre the database outlives it. All functions: @throws IoError, CorruptFile.
  explicit JobHistory(sqlite3* database) : database_(database) {}

  std::vector<PastEvent> events(const EventFilter& filter) const;

  /// Tasks of a job (0: all jobs) with ids above `after`, by rising id, without files; of their
  /// values those that tell what was expected of them, what they took, and their smallest angle.
  /// Cost: of a job, its tasks.
  std::vector<TaskRow> tasks(JobId job, TaskId after, std::size_t limit) const;
  std::optional<TaskRow> task(TaskId task) const;
  /// The sub-domains of a job by rising path.
  std::vector<SubdomainRow> tree(JobId job) const;
  /// Those with paths above `after` only, at most `limit`. Cost: these.
  std::vector<SubdomainRow> tree(JobId job, std::uint64_t after, std::size_t limit) const;

  std::vector<AttemptRow> running_attempts() const;
  /// Every attempt of a task, by rising id, without logs.
  std::vector<AttemptRow> attempts_of(TaskId task) const;
  /// Those of a job (0: all jobs) with ids above `after`, by rising id, without logs.
  std::vector<AttemptRow> attempts_of(JobId job, AttemptId after, std::size_t limit) const;
  /// What the attempt's process said, at most its end; nothing when it is not kept (any longer).
  std::optional<std::string> log_of(AttemptId attempt) const;

  /// The workers with ids above `after`, by rising id; `gone` ones too on demand.
  /// Cost: one pass over the attempts.
  std::vector<WorkerRecord> workers(WorkerId after, std::size_t limit, bool with_gone) const;
  std::optional<WorkerRow> worker(WorkerId id) const;

 private:
  sqlite3* database_;
};

}  // namespace tetfarm
