/// How much room a disk has, and how much of it is left alone.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>

namespace tetfarm {

struct DiskRoom {
  std::uint64_t free_bytes = 0;   ///< for this user
  std::uint64_t total_bytes = 0;  ///< 0: the file system does not say; then nothing is known

  /// Logs, the database and estimates that are too low want room too: 64 MiB, of small disks a
  /// 20th.
  std::uint64_t reserve() const { return std::min(std::uint64_t{64} << 20U, total_bytes / 20); }
  bool has(std::uint64_t bytes) const {
    return total_bytes == 0 || free_bytes >= bytes + reserve();
  }
};

/// Of the disk that `path`, or where that is not there yet the folder above it, lies on.
/// @throws IoError.
DiskRoom disk_room(const std::filesystem::path& path);

}  // namespace tetfarm
