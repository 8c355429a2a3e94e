#include "proto/file_chunks.h"

#include <algorithm>
#include <utility>

#include "base/hash.h"

namespace tetfarm {

std::uint64_t chunk_size(std::uint64_t file_size, std::uint64_t offset) {
  return offset < file_size ? std::min(chunk_bytes, file_size - offset) : 0;
}

void fill_chunk(wire::FileChunk& chunk, std::string bytes) {
  chunk.set_checksum(hash128(bytes).hex());
  chunk.set_bytes(std::move(bytes));
}

bool is_intact(const wire::FileChunk& chunk) {
  return chunk.bytes().size() <= chunk_bytes && hash128(chunk.bytes()).hex() == chunk.checksum();
}

}  // namespace tetfarm
