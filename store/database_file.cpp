#include "store/database_file.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <string_view>

#include "base/check.h"
#include "base/error.h"
#include "store/sqlite_statement.h"

namespace tetfarm {
namespace {

constexpr mode_t private_mode = S_IRUSR | S_IWUSR;
constexpr int busy_timeout_ms = 5000;
constexpr int all_pages = -1;  // at once: what others write between two steps would begin it anew
constexpr int pause_ms = 10;
constexpr int most_pauses = 1000;

/// As a URI in which nothing but the path has a meaning.
std::string uri_of(const std::string& path) {
  std::string uri = "file:";
  for (const char c : path) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '/' || c == '.' || c == '-' || c == '_';
    char text[4] = {c, 0, 0, 0};
    if (!is_plain) std::snprintf(text, sizeof text, "%%%02X", static_cast<unsigned char>(c));
    uri += text;
  }
  return uri;
}

/// SQLite counts the memory it takes under a lock that all connections share; nobody reads that.
void count_no_memory() {
  static const int once = sqlite3_config(SQLITE_CONFIG_MEMSTATUS, 0);
  static_cast<void>(once);  // too late where SQLite runs already: then it counts
}

SqlitePtr open_as(const std::string& name, int flags, const std::string& path) {
  TF_CHECK(!name.empty());
  count_no_memory();
  sqlite3* opened = nullptr;
  const int code = sqlite3_open_v2(name.c_str(), &opened, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  SqlitePtr database(opened);
  if (code != SQLITE_OK) throw_sqlite_error(opened, code, "cannot open " + path);
  sqlite3_extended_result_codes(opened, 1);
  sqlite3_busy_timeout(opened, busy_timeout_ms);
  return database;
}

/// A database with a write-ahead log wants to be written to even by readers; in a folder where that
/// cannot be, one that was closed cleanly is read as a file that nobody changes.
SqlitePtr open_to_read(const std::string& path) {
  SqlitePtr database = open_as(path, SQLITE_OPEN_READONLY, path);
  try {
    Statement(database.get(), "SELECT count(*) FROM sqlite_schema").step();
    return database;
  } catch (const IoError&) {
    if (std::filesystem::exists(path + "-wal")) throw;
  }
  return open_as(uri_of(path) + "?immutable=1", SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, path);
}

/// What is in it is nobody else's business: made for its owner alone, and taken from everybody
/// where an earlier program gave it to them. SQLite gives its log the same rights. What a group was
/// given on purpose it keeps.
void keep_others_out(const std::filesystem::path& path) {
  const sqlite3_vfs* files = sqlite3_vfs_find(nullptr);
  if (files == nullptr || !std::string_view(files->zName).starts_with("unix")) return;
  const int made = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, private_mode);
  if (made < 0) return;  // SQLite says what is wrong
  struct stat about {};
  const bool is_open_to_all = ::fstat(made, &about) == 0 && (about.st_mode & S_IRWXO) != 0;
  if (is_open_to_all && about.st_uid == ::geteuid()) ::fchmod(made, private_mode);
  ::close(made);
}

}  // namespace

void CloseSqlite::operator()(sqlite3* database) const { sqlite3_close_v2(database); }

SqlitePtr open_database(const std::filesystem::path& path, DatabaseAccess access) {
  if (access == DatabaseAccess::write) {
    if (path != ":memory:") keep_others_out(path);
    return open_as(path.string(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, path.string());
  }
  if (!std::filesystem::exists(path)) throw IoError("no database", path.string(), ENOENT);
  return open_to_read(path.string());
}

void copy_database(sqlite3* from, sqlite3* to) {
  TF_CHECK(from != nullptr && to != nullptr && from != to);
  sqlite3_backup* backup = sqlite3_backup_init(to, "main", from, "main");
  if (backup == nullptr) throw_sqlite_error(to, sqlite3_extended_errcode(to), "cannot copy");
  int code = SQLITE_OK;
  int pauses = 0;
  while (code == SQLITE_OK ||
         ((code == SQLITE_BUSY || code == SQLITE_LOCKED) && ++pauses < most_pauses)) {
    if (code != SQLITE_OK) sqlite3_sleep(pause_ms);
    code = sqlite3_backup_step(backup, all_pages);
  }
  const int finished = sqlite3_backup_finish(backup);
  if (code != SQLITE_DONE) throw_sqlite_error(to, code, "cannot copy the database");
  if (finished != SQLITE_OK) throw_sqlite_error(to, finished, "cannot copy the database");
}

}  // namespace tetfarm
