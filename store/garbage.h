/// What lies in a store that no job needs any more, and its removal.
///
/// Only while no coordinator runs on the store (take its lock first): it could just be going to use
/// what is removed. Workers may run: what was touched since the oldest running attempt began, with
/// a margin for clocks that differ, stays.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "store/artifact_store.h"
#include "store/rows.h"

namespace tetfarm {

/// The files that the rows need. Of a done job the results and what it was made from, and unless
/// `all_finished` what lay between; of a running or failed one everything; of a cancelled one
/// nothing. Whatever is not kept can be made again from what is.
std::set<std::string> needed_files(const DurableState& state, bool all_finished);

/// Nothing that was touched at or after this time (milliseconds since 1970) may be removed: an
/// attempt may be writing it.
std::int64_t untouchable_since_ms(const DurableState& state);

struct Garbage {
  std::vector<std::filesystem::path> files;  ///< sorted
  std::uint64_t bytes = 0;
  std::size_t too_young = 0;  ///< not needed, but perhaps being written
};

/// Artifacts that are not needed, unfinished files, leftovers of uploads and probes, and what was
/// set aside as damaged. Cost: looks at every file of the store. @throws IoError.
Garbage find_garbage(const ArtifactStore& store, const std::set<std::string>& needed,
                     std::int64_t untouchable_since_ms);

/// Removes them, and folders that are empty then. @throws IoError.
void remove_garbage(const ArtifactStore& store, const Garbage& garbage);

}  // namespace tetfarm
