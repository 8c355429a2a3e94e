/// Files in pieces, for workers that do not see the store: how large, and how many at once.
///
/// The receiver asks, so that no more is under way than it can take: a worker that fetches has at
/// most `chunks_at_once` requests open, and one that sends is at most so many chunks ahead of what
/// FileStored has told it. Nothing relies on a chunk's arrival: what is not heard of for
/// `chunk_again_ms` is asked for again.
#pragma once

#include <cstdint>
#include <string>

#include "proto/messages.pb.h"

namespace tetfarm {

inline constexpr std::uint64_t chunk_bytes = std::uint64_t{256} << 10U;
inline constexpr std::uint64_t chunks_at_once = 16;
inline constexpr std::int64_t chunk_again_ms = 2'000;

/// Of a file of that size, at that offset: 0 at and behind the end.
std::uint64_t chunk_size(std::uint64_t file_size, std::uint64_t offset);

/// Puts the bytes and their checksum into the chunk.
void fill_chunk(wire::FileChunk& chunk, std::string bytes);

/// Whether they are what was sent.
bool is_intact(const wire::FileChunk& chunk);

}  // namespace tetfarm
