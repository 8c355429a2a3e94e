/// Files that may be packed by gzip, read whole.
#pragma once

#include <string>
#include <string_view>

namespace tetfarm {

/// Told by the first two bytes, not by the name.
bool is_gzip(std::string_view bytes);

/// All members of the file, one after the other.
/// @throws InvalidInput when the data are damaged, cut short or more than 32 GiB unpacked.
std::string unpack_gzip(std::string_view bytes, const std::string& name);

/// @throws IoError
std::string read_whole_file(const std::string& path);

}  // namespace tetfarm
