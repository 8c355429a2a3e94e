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
    is_under_way_ = false;
  }

  /// The offset of a chunk to send or ask for now, of a file of that size whose first `there` bytes
  /// have arrived; nothing when enough is under way. What has not arrived for `chunk_again_ms`, or
  /// some times as long as the last chunk took, is due again.
  std::optional<std::uint64_t> next(std::uint64_t size, std::uint64_t there, std::int64_t now_ms) {
    if (is_under_way_ && now_ms - moved_ms_ > patience_ms_) {
      twice_until_ = std::max(twice_until_, next_);
      start_again(there);
      width_ = std::max<std::uint64_t>(width_ / 2, 1);
      patience_ms_ = std::min(2 * patience_ms_, most_patience_ms);
    }
    if (next_ >= size || next_ >= there + width_ * chunk_bytes) return std::nullopt;
    const std::uint64_t offset = next_;
    next_ += chunk_size(size, offset);
    if (!is_under_way_) {
      is_under_way_ = true;
      sent_ms_ = now_ms;
      watched_ = next_;
      moved_ms_ = now_ms;
    }
    return offset;
  }

  /// The first `there` bytes have arrived.
  void note(std::uint64_t there, std::int64_t now_ms) {
    // Which of two requests was answered is not known: how long it took is not known either.
    const bool is_measured = there > twice_until_;
    // What is asked for twice on a slow connection makes it slower.
    if (is_measured) {
      patience_ms_ =
          std::clamp(slow_chunks * (now_ms - moved_ms_), chunk_again_ms, most_patience_ms);
    }
    moved_ms_ = now_ms;
    if (!is_under_way_ || there < watched_) return;
    const std::int64_t took_ms = now_ms - sent_ms_;
    if (is_measured && took_ms < quick_ms) {
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
  static constexpr std::int64_t slow_chunks = 3;
  static constexpr std::int64_t most_patience_ms = 8'000;

  std::uint64_t next_ = 0;
  std::uint64_t width_ = 2;
  bool is_under_way_ = false;
  std::int64_t sent_ms_ = 0;       ///< when the chunk that is watched went
  std::uint64_t watched_ = 0;      ///< its end
  std::uint64_t twice_until_ = 0;  ///< chunks before it may have been asked for twice
  std::int64_t moved_ms_ = 0;
  std::int64_t patience_ms_ = chunk_again_ms;
};

}  // namespace tetfarm
