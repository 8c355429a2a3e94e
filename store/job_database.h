/// The SQLite database of the coordinator: what has been decided, and which files exist.
///
/// Only the coordinator writes it; each decision is one transaction, durable when apply() returns.
/// An open database is always enough to go on. Tables and states are described in store/formats.md.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "store/database_file.h"
#include "store/job_history.h"
#include "store/rows.h"

namespace tetfarm {

/// The schema that this program writes; older databases are brought up to it when they are opened.
inline constexpr int database_version = 10;

/// How much history is kept: the newest so many.
struct HistoryBounds {
  std::uint64_t events = 200'000;  ///< about 25 MB
  std::uint64_t logs = 20'000;     ///< of attempts, by their ids; each at most longest_log bytes
};

class JobDatabase {
 public:
  /// Opens or makes the database, with a write-ahead log.
  /// @throws UsageError on a network file system; IoError, also when it may be read but not written
  /// to, which is tried; CorruptFile when it is no database of ours, or one of a newer program.
  explicit JobDatabase(const std::filesystem::path& path, const HistoryBounds& bounds = {});
  /// Opens one that is there, whether a coordinator runs or not, and never changes it: an older
  /// schema is brought up in a copy in memory. apply() then fails.
  /// @throws IoError (not_found when there is none), CorruptFile.
  static JobDatabase open_to_read(const std::filesystem::path& path);
  ~JobDatabase();
  JobDatabase(const JobDatabase&) = delete;
  JobDatabase& operator=(const JobDatabase&) = delete;

  /// Writes all rows in one transaction, or none. Durable when it returns.
  /// @throws IoError (out_of_resources when the disk is full).
  void apply(const ChangeSet& changes);

  /// Writes what is there already in a transaction of its own: may it be written to?
  /// @throws IoError as apply does.
  void try_to_write();

  /// Everything in it, into a file that is not there yet. @throws IoError.
  void save_copy(const std::filesystem::path& file) const;

  /// Closing it will leave the files as they are: for when others lie under their names, which
  /// SQLite would take for its own.
  void leave_files_alone();

  /// Everything that decides what happens next. Cost: one pass over the tables.
  DurableState load() const;
  /// The same without tasks and sub-domains of jobs that have ended and of which nothing runs.
  DurableState load_unfinished() const;
  /// One job with its tasks and sub-domains; empty when there is no such job.
  DurableState load_job(JobId job) const;
  std::optional<TaskRow> find_task(TaskId task) const;

  /// What happened, for people. @pre this outlives it.
  JobHistory history() const;

  /// What SQLite's own check finds wrong; empty when all is well. Cost: reads the whole database.
  std::vector<std::string> damage() const;

 private:
  struct Writing;

  explicit JobDatabase(SqlitePtr database);

  HistoryBounds bounds_;
  SqlitePtr database_;
  std::unique_ptr<Writing> writing_;  ///< goes before its database; none before the first change
};

}  // namespace tetfarm
