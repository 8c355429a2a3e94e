// Amounts of memory and of room on disks, in messages.
#pragma once

#include <cstdint>
#include <string>

namespace tetfarm {

/// "37 MiB", rounded down.
inline std::string mebibytes(std::uint64_t bytes) { return std::to_string(bytes >> 20U) + " MiB"; }

}  // namespace tetfarm
