/// Opens SQLite files and copies them while they are in use.
#pragma once

#include <filesystem>
#include <memory>

struct sqlite3;

namespace tetfarm {

struct CloseSqlite {
  void operator()(sqlite3* database) const;
};
using SqlitePtr = std::unique_ptr<sqlite3, CloseSqlite>;

enum class DatabaseAccess {
  write,  ///< made when it is missing
  read,
};

/// `path` may be ":memory:". One that is made has mode 0600. Read, also in a folder that may not be
/// written to, as long as no process left a log of changes there.
/// @throws IoError (not_found when there is none to read), CorruptFile.
SqlitePtr open_database(const std::filesystem::path& path, DatabaseAccess access);

/// Copies all of `from`, as it is between two transactions, over all of `to`. Others may go on
/// writing to `from`. @throws IoError, CorruptFile. Cost: reads and writes the whole database.
void copy_database(sqlite3* from, sqlite3* to);

}  // namespace tetfarm
