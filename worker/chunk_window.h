/// How many chunks of a file may be under way: few on a slow connection, so that other messages are
/// not stuck behind seconds of chunks, up to `chunks_at_once` on a fast one.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "proto/file_chunks.h"

namespace tetfarm {

class ChunkWindow {
 public:
  /// Nothing is under way from `offset` on.
  void start_again(std::uint64_t offset) {
    next_ = offset;
    sent_ms_.reset();
  }

  /// The offset of a chunk to send or ask for now, of a file of that size whose first `there` bytes
  /// have arrived; nothing when enough is under way. What has not arrived for `chunk_again_ms` is
  /// due again.
  std::optional<std::uint64_t> next(std::uint64_t size, std::uint64_t there, std::int64_t now_ms) {
    if (sent_ms_ && now_ms - moved_ms_ > chunk_again_ms) start_again(there);
    if (next_ >= size || next_ >= there + width_ * chunk_bytes) return std::nullopt;
    const std::uint64_t offset = next_;
    next_ += chunk_size(size, offset);
    if (!sent_ms_) {
      sent_ms_ = now_ms;
      watched_ = next_;
      moved_ms_ = now_ms;
    }
    return offset;
  }

  /// The first `there` bytes have arrived.
  void note(std::uint64_t there, std::int64_t now_ms) {
    moved_ms_ = now_ms;
    if (!sent_ms_ || there < watched_) return;
    const std::int64_t took_ms = now_ms - *sent_ms_;
    if (took_ms < quick_ms) {
      width_ = std::min(width_ * 2, chunks_at_once);
    } else if (took_ms > slow_ms) {
      width_ = std::max<std::uint64_t>(width_ / 2, 1);
    }
    sent_ms_ = now_ms;
    watched_ = std::max(next_, there + 1);
  }

  std::uint64_t width() const { return width_; }

 private:
  static constexpr std::int64_t quick_ms = 250;
  static constexpr std::int64_t slow_ms = 1'000;

  std::uint64_t next_ = 0;
  std::uint64_t width_ = 2;
  std::optional<std::int64_t>
      sent_ms_;                ///< when the chunk that is watched went; nothing is under way
  std::uint64_t watched_ = 0;  ///< its end
  std::int64_t moved_ms_ = 0;
};

}  // namespace tetfarm
