/// Whether a folder lies on a file system of the network, where SQLite's locks and shared memory
/// cannot be relied upon and a database may be damaged.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace tetfarm {

/// The kind of network file system ("nfs", "fuse.sshfs"), "" for one that is not known as such.
/// @throws IoError.
std::string network_file_system_of(const std::filesystem::path& folder);

/// The same of the number that statfs gives for a file system (its low 32 bits) and the kind that
/// the table of mounts names, "" when that is not known.
std::string network_file_system_named(std::uint32_t magic, std::string_view kind);

/// The kind of the file system that is mounted as `device` ("254:0") in the text of
/// /proc/self/mountinfo; "" when it is not there.
std::string mounted_kind(std::string_view mounts, std::string_view device);

}  // namespace tetfarm
