#include "store/database_backup.h"

#include <sqlite3.h>

#include <algorithm>
#include <system_error>

#include "base/error.h"
#include "base/file_system.h"
#include "base/undo_unless_done.h"
#include "store/database_file.h"
#include "store/job_database.h"
#include "store/schema.h"
#include "store/sqlite_statement.h"

namespace tetfarm {
namespace {

/// More than are given out between a backup and its restore.
constexpr std::uint64_t attempts_apart = 1'000'000'000;

std::filesystem::path beside(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  return folder / unique_temp_name(path.filename().string());
}

void check_soundness(const JobDatabase& database, const std::filesystem::path& path) {
  const std::vector<std::string> damage = database.damage();
  if (!damage.empty()) throw CorruptFile(damage.front(), path.string());
}

/// A file of its own, without a log beside it.
void write_copy(sqlite3* from, const std::filesystem::path& file) {
  const SqlitePtr copy = open_database(file, DatabaseAccess::write);
  copy_database(from, copy.get());
  execute(copy.get(), "PRAGMA journal_mode = DELETE");
}

std::uint64_t last_attempt_of(const std::filesystem::path& database) {
  try {
    return JobDatabase::open_to_read(database).load().last_attempt;
  } catch (const Error&) {
    return 0;  // it is being replaced because it cannot be read
  }
}

void remove_with_log(const std::filesystem::path& database) {
  for (const char* part : {"-wal", "-shm", ""}) remove_file(database.string() + part);
}

/// What is left of a copy that failed; that it cannot be removed is not worth a word.
void discard_with_log(const std::filesystem::path& database) {
  std::error_code ignored;
  for (const char* part : {"-wal", "-shm", ""}) {
    std::filesystem::remove(database.string() + part, ignored);
  }
}

}  // namespace

void back_up_database(const std::filesystem::path& database, const std::filesystem::path& file) {
  const std::filesystem::path temporary = beside(file);
  UndoUnlessDone copying([&temporary] { discard_with_log(temporary); });
  write_copy(open_database(database, DatabaseAccess::read).get(), temporary);
  check_soundness(JobDatabase::open_to_read(temporary), temporary);
  publish_by_rename(temporary, file);
  copying.done();
}

std::filesystem::path restore_database(const std::filesystem::path& file,
                                       const std::filesystem::path& database,
                                       std::int64_t now_wall_ms) {
  check_soundness(JobDatabase::open_to_read(file), file);
  const std::filesystem::path temporary = beside(database);
  std::filesystem::path kept;
  UndoUnlessDone copying([&temporary] { discard_with_log(temporary); });
  write_copy(open_database(file, DatabaseAccess::read).get(), temporary);
  {
    const SqlitePtr restored = open_database(temporary, DatabaseAccess::write);
    execute(restored.get(), "PRAGMA foreign_keys = OFF");
    migrate(restored.get());
    const std::uint64_t floor =
        std::max(last_attempt_of(file), last_attempt_of(database)) + attempts_apart;
    Statement raise(restored.get(), "INSERT OR REPLACE INTO floors VALUES ('attempt', ?)");
    raise.bind(floor).run();
  }
  if (std::filesystem::exists(database)) {
    kept = database.string() + ".before-restore-" + std::to_string(now_wall_ms);
    try {
      write_copy(open_database(database, DatabaseAccess::read).get(), kept);
    } catch (const CorruptFile&) {
      // As it is, then: somebody may want to look into it.
      std::filesystem::copy_file(database, kept, std::filesystem::copy_options::overwrite_existing);
    }
    remove_with_log(database);
  }
  publish_by_rename(temporary, database);
  copying.done();
  return kept;
}

}  // namespace tetfarm
