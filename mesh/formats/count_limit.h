/// Formats, or the programs that read them, whose counts have 32 bits: larger meshes are refused
/// before anything is written.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace tetfarm {

inline constexpr std::int64_t most_of_32_bits = std::numeric_limits<std::int32_t>::max();

/// @throws Error when `count` is above 2^31 - 1: "the mesh is too large for FORMAT, ...: 2147483648
/// WHAT; INSTEAD".
void require_32_bits(std::int64_t count, const std::string& what, const std::string& format,
                     const std::string& instead);

}  // namespace tetfarm
