/// A prepared SQLite statement whose every step is checked.
///
/// SQLite's result codes become the errors of base/error.h here and nowhere else.
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace tetfarm {

/// Throws what `code` means for the database: CorruptFile or IoError (ENOSPC when full, EBUSY when
/// locked, EROFS when it may not be written to, EIO, …; EINVAL when the world is not to blame but a
/// statement, which is wrong or breaks a rule of the tables).
[[noreturn]] void throw_sqlite_error(sqlite3* database, int code, const std::string& what);

/// Runs statements without results. @throws IoError, CorruptFile.
void execute(sqlite3* database, const char* sql);

class Statement {
 public:
  /// @throws IoError, CorruptFile.
  Statement(sqlite3* database, const char* sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  /// Binds the next parameter, from the first on.
  Statement& bind(std::int64_t value);
  Statement& bind(std::uint64_t value) { return bind(static_cast<std::int64_t>(value)); }
  Statement& bind(std::uint32_t value) { return bind(static_cast<std::int64_t>(value)); }
  Statement& bind(std::int32_t value) { return bind(static_cast<std::int64_t>(value)); }
  Statement& bind(double value);
  Statement& bind(std::string_view value);
  Statement& bind(const char* value) { return bind(std::string_view(value)); }
  Statement& bind_null();

  /// Goes to the next row; false when there is none. @throws IoError, CorruptFile.
  bool step();

  /// Runs a statement without rows and makes it ready for new values.
  void run();

  /// Makes a statement with rows ready for new values.
  void rewind();

  /// Reads the next column of the row, from the first on.
  std::int64_t integer();
  std::uint64_t unsigned_integer() { return static_cast<std::uint64_t>(integer()); }
  double real();
  std::string text();

 private:
  void check(int code);

  sqlite3* database_;
  sqlite3_stmt* statement_ = nullptr;
  int next_parameter_ = 1;
  int next_column_ = 0;
};

}  // namespace tetfarm
