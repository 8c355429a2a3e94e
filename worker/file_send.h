/// One file that goes to the coordinator chunk by chunk.
///
/// Without a socket: it says what to send, and is told how much of it is there. What is sent is at
/// most `chunks_at_once` chunks ahead of that; after a break it goes on from there.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "proto/messages.pb.h"
#include "store/artifact_store.h"
#include "worker/chunk_window.h"

namespace tetfarm {

class FileSend {
 public:
  explicit FileSend(StoredArtifact file) : file_(std::move(file)) {}

  const StoredArtifact& file() const { return file_; }
  bool is_whole() const { return is_whole_; }
  /// Bytes that the coordinator has.
  std::uint64_t there() const { return there_; }
  /// How often it went back to what was sent before: a chunk was lost, or the file is not what its
  /// name says.
  int setbacks() const { return setbacks_; }

  struct Due {
    bool offer = false;                 ///< the answer says where to begin
    std::vector<std::uint64_t> chunks;  ///< where they begin
  };
  /// What to send now.
  Due due(std::int64_t now_ms);
  /// Whether it is about this file.
  bool take(const wire::FileStored& stored, std::int64_t now_ms);
  /// The connection is new.
  void ask_again() { offered_ms_ = never; }

 private:
  static constexpr std::int64_t never = -(std::int64_t{1} << 60);
  static constexpr std::int64_t resend_pause_ms = 500;

  StoredArtifact file_;
  bool is_whole_ = false;
  bool is_open_ = false;  ///< the coordinator has said where to begin
  std::int64_t offered_ms_ = never;
  std::int64_t heard_ms_ = never;
  std::int64_t resent_ms_ = never;
  std::uint64_t there_ = 0;
  std::uint64_t sent_ = 0;  ///< up to here, since it was last said where to go on
  int setbacks_ = 0;
  ChunkWindow window_;
};

}  // namespace tetfarm
