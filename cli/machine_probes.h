/// What `tetfarm doctor` asks of the machine that it runs on: memory, open files, room on a disk.
#pragma once

#include <cstdint>
#include <filesystem>

#include "cli/findings.h"
#include "store/disk_room.h"

namespace tetfarm {

struct MemoryOfMachine {
  std::uint64_t bytes = 0;
  std::uint64_t available_bytes = 0;
};

/// @param wanted_bytes what a worker is told that it may take; 0: all, which is what it takes where
/// nobody tells it
Finding finding_of_memory(const MemoryOfMachine& machine, std::uint64_t wanted_bytes);

/// @param most how many files a process may have open at once, at the most that it may ask for
Finding finding_of_open_files(std::uint64_t most);
/// Of this process. @throws IoError.
Finding look_at_open_files();

/// @param free_files how many more the file system has room for; the largest number where it does
/// not say
Finding finding_of_room(const std::filesystem::path& folder, const DiskRoom& room,
                        std::uint64_t free_files);
/// Of the disk that the folder lies on, or will lie on. @throws IoError.
Finding look_at_room(const std::filesystem::path& folder);

}  // namespace tetfarm
