#include "store/job_database.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <string>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/undo_unless_done.h"
#include "store/database_file.h"
#include "store/network_file_system.h"
#include "store/row_reader.h"
#include "store/row_writer.h"
#include "store/schema.h"
#include "store/sqlite_statement.h"

namespace tetfarm {
namespace {

/// The write-ahead log needs memory that processes share, and all of SQLite needs locks that hold:
/// a network file system promises neither, and the damage would show much later.
void refuse_network_file_system(const std::filesystem::path& folder) {
  const std::string kind = network_file_system_of(folder);
  if (kind.empty()) return;
  throw UsageError("the database cannot be on a network file system (" + kind +
                       "): its locks do not work there, and it would be damaged; give a folder on "
                       "a local disk with --database DIR (the store itself may stay where it is)",
                   folder.string());
}

bool is_forbidden(int error_number) {
  return error_number == EROFS || error_number == EACCES || error_number == EPERM;
}

[[noreturn]] void refuse_read_only(const std::filesystem::path& path, int error_number) {
  throw IoError(
      "the database can be read but not written to; a coordinator needs to write to this file and "
      "to its folder: change their permissions or owner, mount the disk for writing, or give "
      "another folder with --database DIR",
      path.string(), error_number);
}

void roll_back(sqlite3* database) {
  TF_CHECK(database != nullptr);
  // Some errors end the transaction by themselves; a second ROLLBACK would only hide the first.
  if (sqlite3_get_autocommit(database) != 0) return;
  sqlite3_exec(database, "ROLLBACK", nullptr, nullptr, nullptr);
}

constexpr const char* forget_events =
    "DELETE FROM events WHERE id <= (SELECT max(id) FROM events) - ?";
constexpr const char* forget_logs =
    "DELETE FROM attempt_logs WHERE attempt <= (SELECT max(attempt) FROM attempt_logs) - ?";

}  // namespace

/// What each transaction needs, prepared once.
struct JobDatabase::Writing {
  explicit Writing(sqlite3* database)
      : rows(database), events(database, forget_events), logs(database, forget_logs) {}

  /// Forgets what lies further back than the bounds say. Ids rise without gaps, so this touches
  /// only what it removes.
  void forget_the_oldest(const HistoryBounds& bounds) {
    events.bind(bounds.events).run();
    logs.bind(bounds.logs).run();
  }

  RowWriter rows;
  Statement events;
  Statement logs;
};

JobDatabase::JobDatabase(const std::filesystem::path& path, const HistoryBounds& bounds)
    : bounds_(bounds) {
  refuse_network_file_system(path.has_parent_path() ? path.parent_path() : ".");
  database_ = open_database(path, DatabaseAccess::write);
  sqlite3* opened = database_.get();
  // What SQLite may not write to it opens all the same, to read.
  if (sqlite3_db_readonly(opened, "main") == 1) {
    refuse_read_only(path,
                     ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0 ? EROFS : errno);
  }
  try {
    execute(opened, "PRAGMA journal_mode = WAL");
    execute(opened, "PRAGMA synchronous = FULL; PRAGMA foreign_keys = OFF;");
    // A table that is built anew is dropped first, which foreign keys would forbid.
    migrate(opened);
    execute(opened, "PRAGMA foreign_keys = ON");
    try_to_write();
  } catch (const IoError& error) {
    if (is_forbidden(error.error_number())) refuse_read_only(path, error.error_number());
    throw;
  }
}

JobDatabase::JobDatabase(SqlitePtr database) : database_(std::move(database)) {
  TF_CHECK(database_ != nullptr);
}

JobDatabase JobDatabase::open_to_read(const std::filesystem::path& path) {
  SqlitePtr database = open_database(path, DatabaseAccess::read);
  if (schema_version(database.get()) != database_version) {
    // An older one is brought up in memory; the file stays as it is.
    SqlitePtr copy = open_database(":memory:", DatabaseAccess::write);
    copy_database(database.get(), copy.get());
    migrate(copy.get());
    database = std::move(copy);
  }
  return JobDatabase(std::move(database));
}

JobDatabase::~JobDatabase() = default;

void JobDatabase::apply(const ChangeSet& changes) {
  if (changes.empty()) return;
  execute(database_.get(), "BEGIN IMMEDIATE");
  UndoUnlessDone transaction([this] {
    writing_.reset();
    roll_back(database_.get());
  });
  if (!writing_) writing_ = std::make_unique<Writing>(database_.get());
  writing_->rows.write(changes);
  if (!changes.events.empty()) writing_->forget_the_oldest(bounds_);
  execute(database_.get(), "COMMIT");
  transaction.done();
}

void JobDatabase::try_to_write() {
  // SQLite writes the page of the version whether it changes or not.
  const std::string sql =
      "BEGIN IMMEDIATE; PRAGMA user_version = " + std::to_string(schema_version(database_.get())) +
      "; COMMIT";
  UndoUnlessDone transaction([this] { roll_back(database_.get()); });
  execute(database_.get(), sql.c_str());
  transaction.done();
}

void JobDatabase::save_copy(const std::filesystem::path& file) const {
  const SqlitePtr copy = open_database(file, DatabaseAccess::write);
  copy_database(database_.get(), copy.get());
  execute(copy.get(), "PRAGMA journal_mode = DELETE");
}

void JobDatabase::leave_files_alone() {
  sqlite3_db_config(database_.get(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
}

DurableState JobDatabase::load() const { return read_state(database_.get(), JobsToRead::all); }

DurableState JobDatabase::load_unfinished() const {
  return read_state(database_.get(), JobsToRead::unfinished);
}

DurableState JobDatabase::load_job(JobId job) const { return read_job(database_.get(), job); }

std::optional<TaskRow> JobDatabase::find_task(TaskId task) const {
  return read_task(database_.get(), task);
}

JobHistory JobDatabase::history() const { return JobHistory(database_.get()); }

std::vector<std::string> JobDatabase::damage() const {
  std::vector<std::string> found;
  Statement check(database_.get(), "PRAGMA integrity_check");
  while (check.step()) {
    std::string line = check.text();
    if (line != "ok") found.push_back(std::move(line));
  }
  Statement keys(database_.get(), "PRAGMA foreign_key_check");
  while (keys.step()) found.push_back("a row of " + keys.text() + " points nowhere");
  return found;
}

}  // namespace tetfarm
