/// The frame of most artifact files: a magic of eight bytes and a version first, an XXH3-128 of all
/// before it last.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "mesh/artifacts/byte_stream.h"

namespace tetfarm {

constexpr std::size_t checksum_size = 16;

/// Magic and version are written. `rest` is what will follow but for the checksum, bytes, where
/// that is known: then nothing is copied while it grows.
ByteWriter begin_checked(std::string_view magic, std::uint32_t version, std::size_t rest = 0);
/// Whether the bytes begin like that; what else they say is looked at by who reads on.
bool says_version(std::string_view bytes, std::string_view magic, std::uint32_t version);
/// Adds the checksum.
std::string finish_checked(ByteWriter writer);

/// Of what lies between version and checksum. Both must outlive it.
/// @throws CorruptFile naming `name`: another magic, version or checksum, or cut short.
ByteReader read_checked(std::string_view bytes, std::string_view magic, std::uint32_t version,
                        const std::string& name);

/// Behind magic and version, whatever comes at the end. @throws CorruptFile naming `name`.
ByteReader read_begun(std::string_view bytes, std::string_view magic, std::uint32_t version,
                      const std::string& name);

}  // namespace tetfarm
