/// Pieces of a file and what they must hold.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "base/hash.h"

namespace tetfarm {

struct FileRange {
  std::int64_t offset = 0;
  std::int64_t size = 0;
  Hash128 hash;

  friend bool operator==(const FileRange&, const FileRange&) = default;
};

/// A file that was read from beginning to end.
struct ReadThrough {
  Hash128 hash;                    ///< of the whole file
  std::int64_t size = 0;           ///< bytes
  std::vector<std::size_t> wrong;  ///< the ranges that do not hold what they must, ascending
};

/// Reads the file once, and looks at all ranges on the way; one beyond the end is wrong.
/// @pre the ranges ascend and do not overlap. @throws IoError. Cost: constant memory.
ReadThrough read_through(const std::filesystem::path& path, std::span<const FileRange> ranges);

}  // namespace tetfarm
