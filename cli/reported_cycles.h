/// What the page about an adaptation loop shows: from the folder into which the loop was delivered.
#pragma once

#include <filesystem>

#include "report/cycles_page.h"

namespace tetfarm {

/// Cycles that are shown at most: the first, the last, and others evenly between.
inline constexpr std::size_t most_shown_cycles = 8;

/// Whether it has the table and the first mesh of a loop.
bool is_loop_folder(const std::filesystem::path& folder);

/// Of each shown cycle its mesh and the first field of its solution, where most nodes of the last
/// mesh are. One mesh at a time is in memory.
/// @param picture_width in pixels. @pre is_loop_folder(). @throws InvalidInput, IoError with the
/// file and the line: one is missing, or is not what a loop writes.
CyclesContent reported_cycles(const std::filesystem::path& folder, int picture_width = 960);

}  // namespace tetfarm
