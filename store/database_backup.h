/// Copies of the database for a rainy day.
///
/// A backup holds rows, not artifacts: what it names and the store has lost is made again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace tetfarm {

/// Copies the database as it is between two transactions, while others may use it, into one file
/// that is there whole or not at all. An older file of that name is replaced.
/// @throws IoError, CorruptFile (also when the copy is not sound). Cost: reads and writes all of
/// it.
void back_up_database(const std::filesystem::path& database, const std::filesystem::path& file);

/// Puts the backup in the place of the database, which is kept under a name of its own. Attempts of
/// the time that is undone stay stale: their ids are not given out again.
/// @pre no coordinator uses the database. @return the name of the one that was there, "": none.
/// @throws IoError, CorruptFile when `file` is no sound database of ours, or a newer program's.
std::filesystem::path restore_database(const std::filesystem::path& file,
                                       const std::filesystem::path& database,
                                       std::int64_t now_wall_ms);

}  // namespace tetfarm
