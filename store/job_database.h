/// The SQLite database of the coordinator: what has been decided, and which files exist.
///
/// Only the coordinator writes it; each decision is one transaction, durable when apply() returns.
/// An open database is always enough to go on. Tables and states are described in store/formats.md.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "store/rows.h"

struct sqlite3;

namespace tetfarm {

/// The schema that this program writes; older databases are brought up to it when they are opened.
inline constexpr int database_version = 4;

class JobDatabase {
 public:
  /// Opens or makes the database, with a write-ahead log.
  /// @throws UsageError on a network file system; IoError, CorruptFile when it is no database of
  /// ours, or one of a newer program.
  explicit JobDatabase(const std::filesystem::path& path);
  ~JobDatabase();
  JobDatabase(const JobDatabase&) = delete;
  JobDatabase& operator=(const JobDatabase&) = delete;

  /// Writes all rows in one transaction, or none. Durable when it returns.
  /// @throws IoError (out_of_resources when the disk is full).
  void apply(const ChangeSet& changes);

  /// Everything that decides what happens next. Cost: one pass over the tables.
  DurableState load() const;

  /// The history of a job, oldest first.
  std::vector<EventRow> events_of(JobId job) const;

  /// Every attempt ever made, by rising id.
  std::vector<AttemptRow> all_attempts() const;

  /// What SQLite's own check finds wrong; empty when all is well. Cost: reads the whole database.
  std::vector<std::string> damage() const;

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::string path_;
  std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace tetfarm
