/// What `tetfarm doctor` tries in a folder that a coordinator or a run is to work in: whether files
/// that are written, synced, renamed and locked there are what they should be, which times they
/// get, and whether a database may lie there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "cli/findings.h"

namespace tetfarm {

/// Writes a file and removes it. @throws Error, IoError when that cannot be done.
Finding look_at_files(const std::filesystem::path& folder);

/// Whether SQLite can keep a database there. @throws IoError.
Finding look_at_database(const std::filesystem::path& folder);
/// @param kind of network file system; "": none
Finding finding_of_database(const std::filesystem::path& folder, const std::string& kind);

/// Writes a file and looks at the time that it has. @throws IoError.
Finding look_at_times_of_files(const std::filesystem::path& folder);

/// @param whose "files in /farm", "the clock of the coordinator". @param ahead_ms of our clock;
/// less than 0: behind it
Finding finding_of_clock(const std::string& whose, std::int64_t ahead_ms);

}  // namespace tetfarm
