/// Writes the rows of a change set into the database's tables.
///
/// Its statements are prepared once. After an error it is of no more use: a statement may be left
/// in the middle.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "store/rows.h"
#include "store/sqlite_statement.h"

struct sqlite3;

namespace tetfarm {

class RowWriter {
 public:
  /// @pre the database has our schema, and outlives it. @throws IoError, CorruptFile.
  explicit RowWriter(sqlite3* database);

  /// @pre a transaction is open. @throws IoError, CorruptFile.
  void write(const ChangeSet& changes);

 private:
  void write(const JobRow& job);
  void write(const SubdomainRow& row);
  void write(const TaskRow& task);
  void write(const WorkerRow& worker);
  void write(const AttemptRow& attempt);
  void write(const HostRow& host);
  void write(const EventRow& event);
  void remove(JobId job);
  void write_files(Statement& statement, TaskId task, const std::vector<ArtifactRef>& files);
  void write_texts(TaskId task, const char* sort, const std::map<std::string, std::string>& texts);
  void forget_old_result(const TaskRow& task);
  static Statement& bind_progress(Statement& statement, const TaskRow& task);

  sqlite3* database_;
  Statement job_;
  Statement artifact_;
  Statement subdomain_;
  Statement task_update_;
  Statement task_insert_;
  Statement input_;
  Statement result_find_;
  Statement output_forget_;
  Statement output_;
  Statement result_forget_;
  Statement value_;
  Statement worker_;
  Statement attempt_;
  Statement log_;
  Statement host_;
  Statement event_;
};

}  // namespace tetfarm
