/// Files that may be packed by gzip, read whole.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tetfarm {

/// Told by the first two bytes, not by the name.
bool is_gzip(std::string_view bytes);

/// How much so many packed bytes may hold: 200 times as much, but 64 MiB in any case and 32 GiB at
/// most.
std::uint64_t most_unpacked(std::uint64_t packed_bytes);

/// All members of the file, one after the other. Unpacks twice, to count first: what is refused for
/// its size takes no memory.
/// @throws InvalidInput when the data are damaged, cut short or hold more than most_unpacked().
std::string unpack_gzip(std::string_view bytes, const std::string& name);

/// @throws IoError
std::string read_whole_file(const std::string& path);

}  // namespace tetfarm
