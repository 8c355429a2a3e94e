/// One file that comes from the coordinator chunk by chunk, into a file that grows.
///
/// Without a socket: it says which chunks to ask for, and is told what came. At most
/// `chunks_at_once` requests are open; the number follows the connection, so that a slow one is not
/// filled for seconds.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "base/hash.h"
#include "proto/messages.pb.h"
#include "store/artifact_store.h"
#include "worker/chunk_window.h"

namespace tetfarm {

class FileReceive {
 public:
  /// What `growing` has already is gone on from, but for a chunk that is not whole.
  /// @pre nobody else writes to `growing`. @throws IoError. Cost: one pass over what is there.
  FileReceive(std::filesystem::path growing, StoredArtifact file);

  enum class State {
    coming,
    whole,    ///< all there, and what its name says
    damaged,  ///< all there, but other bytes
    missing   ///< the coordinator does not have it, or not so long
  };
  State state() const { return state_; }
  const StoredArtifact& file() const { return file_; }
  const std::filesystem::path& path() const { return growing_; }
  std::uint64_t there() const { return there_; }
  /// Bytes that were there before this process came.
  std::uint64_t found() const { return found_; }

  /// Where a chunk begins that is to be asked for now; to be called until there is none.
  std::optional<std::uint64_t> next(std::int64_t now_ms);
  /// Whether it was the chunk that was waited for. @throws IoError (out_of_resources when there is
  /// no room for it).
  bool take(const wire::FileChunk& chunk, std::int64_t now_ms);
  /// The connection is new: what was asked for is asked for again.
  void ask_again() { window_.start_again(there_); }

 private:
  void go_on_from_what_is_there();
  void finish_when_all_is_there();

  std::filesystem::path growing_;
  StoredArtifact file_;
  Hasher hasher_;
  State state_ = State::coming;
  std::uint64_t there_ = 0;
  std::uint64_t found_ = 0;
  ChunkWindow window_;
};

}  // namespace tetfarm
