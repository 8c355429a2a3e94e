#include "store/sqlite_statement.h"

#include <cerrno>

#include "base/check.h"
#include "base/error.h"

namespace tetfarm {
namespace {

/// What the system said when a file of the database failed last: of failed commits SQLite tells it
/// in this way only. 0: nothing.
int last_errno(sqlite3* database) {
  sqlite3_file* log = nullptr;
  int error_number = 0;
  sqlite3_file_control(database, "main", SQLITE_FCNTL_JOURNAL_POINTER, &log);
  if (log != nullptr && log->pMethods != nullptr) {
    log->pMethods->xFileControl(log, SQLITE_FCNTL_LAST_ERRNO, &error_number);
  }
  if (error_number != 0) return error_number;
  sqlite3_file_control(database, "main", SQLITE_FCNTL_LAST_ERRNO, &error_number);
  return error_number;
}

/// EINVAL where the world is not to blame but what was asked for.
int errno_of(sqlite3* database, int code) {
  switch (code & 0xff) {
    case SQLITE_FULL:
      return ENOSPC;
    case SQLITE_NOMEM:
      return ENOMEM;
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return EBUSY;
    case SQLITE_READONLY:
      return EROFS;
    case SQLITE_PERM:
      return EACCES;
    case SQLITE_IOERR:
    case SQLITE_CANTOPEN: {
      const int system_error = database != nullptr ? sqlite3_system_errno(database) : 0;
      if (system_error != 0) return system_error;
      const int file_error = database != nullptr ? last_errno(database) : 0;
      if (file_error != 0) return file_error;
      // SQLite tells a full disk from other failed writes, but not a quota or a limit on the file's
      // size.
      return code == SQLITE_IOERR_WRITE ? EFBIG : EIO;
    }
    case SQLITE_PROTOCOL:
    case SQLITE_NOLFS:
      return EIO;
    default:
      return EINVAL;
  }
}

}  // namespace

void throw_sqlite_error(sqlite3* database, int code, const std::string& what) {
  TF_CHECK(code != SQLITE_OK && code != SQLITE_ROW && code != SQLITE_DONE);
  const char* path = database != nullptr ? sqlite3_db_filename(database, "main") : nullptr;
  const std::string file = path != nullptr ? path : "database";
  const std::string message =
      what + " (" + (database != nullptr ? sqlite3_errmsg(database) : sqlite3_errstr(code)) + ")";
  const int kind = code & 0xff;
  if (kind == SQLITE_CORRUPT || kind == SQLITE_NOTADB) throw CorruptFile(message, file);
  throw IoError(message, file, errno_of(database, code));
}

void execute(sqlite3* database, const char* sql) {
  TF_CHECK(database != nullptr);
  const int code = sqlite3_exec(database, sql, nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) throw_sqlite_error(database, sqlite3_extended_errcode(database), sql);
}

Statement::Statement(sqlite3* database, const char* sql) : database_(database) {
  TF_CHECK(database != nullptr);
  check(sqlite3_prepare_v2(database, sql, -1, &statement_, nullptr));
}

Statement::~Statement() { sqlite3_finalize(statement_); }

void Statement::check(int code) {
  if (code == SQLITE_OK) return;
  const char* sql = statement_ != nullptr ? sqlite3_sql(statement_) : nullptr;
  throw_sqlite_error(database_, code, sql != nullptr ? sql : "cannot prepare a statement");
}

Statement& Statement::bind(std::int64_t value) {
  TF_CHECK(next_parameter_ <= sqlite3_bind_parameter_count(statement_));
  check(sqlite3_bind_int64(statement_, next_parameter_++, value));
  return *this;
}

Statement& Statement::bind(double value) {
  TF_CHECK(next_parameter_ <= sqlite3_bind_parameter_count(statement_));
  check(sqlite3_bind_double(statement_, next_parameter_++, value));
  return *this;
}

Statement& Statement::bind(std::string_view value) {
  TF_CHECK(next_parameter_ <= sqlite3_bind_parameter_count(statement_));
  check(sqlite3_bind_text64(statement_, next_parameter_++, value.data(), value.size(),
                            SQLITE_TRANSIENT, SQLITE_UTF8));
  return *this;
}

Statement& Statement::bind_null() {
  TF_CHECK(next_parameter_ <= sqlite3_bind_parameter_count(statement_));
  check(sqlite3_bind_null(statement_, next_parameter_++));
  return *this;
}

bool Statement::step() {
  next_column_ = 0;
  const int code = sqlite3_step(statement_);
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  check(code);
  return false;
}

void Statement::run() {
  step();
  rewind();
}

void Statement::rewind() {
  check(sqlite3_reset(statement_));
  next_parameter_ = 1;
}

std::int64_t Statement::integer() {
  TF_CHECK(next_column_ < sqlite3_data_count(statement_));
  return sqlite3_column_int64(statement_, next_column_++);
}

double Statement::real() {
  TF_CHECK(next_column_ < sqlite3_data_count(statement_));
  return sqlite3_column_double(statement_, next_column_++);
}

std::string Statement::text() {
  TF_CHECK(next_column_ < sqlite3_data_count(statement_));
  const int column = next_column_++;
  const unsigned char* bytes = sqlite3_column_text(statement_, column);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_, column));
  return bytes == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(bytes), size);
}

}  // namespace tetfarm
