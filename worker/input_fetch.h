/// Brings the inputs of a task from the coordinator into the worker's own store, chunk by chunk.
///
/// Without a socket: it says what to send, and is told what came. At most `chunks_at_once` requests
/// are open; the number follows the connection, so that a slow one is not filled for seconds.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/hash.h"
#include "proto/messages.pb.h"
#include "worker/chunk_window.h"
#include "worker/task_cache.h"

namespace tetfarm {

class InputFetch {
 public:
  /// Makes room for what is missing. `cache` outlives it. @throws IoError.
  InputFetch(const TaskCache& cache, const wire::Assign& assign);
  /// Removes what is half there.
  ~InputFetch();
  InputFetch(const InputFetch&) = delete;
  InputFetch& operator=(const InputFetch&) = delete;

  bool is_complete() const { return files_.empty(); }
  /// An input that the coordinator does not have, or has with other bytes; "": none.
  const std::string& damaged() const { return damaged_; }

  /// What to ask now.
  std::vector<wire::Envelope> due(std::int64_t now_ms);
  /// @throws IoError (out_of_resources when there is no room for it).
  void take(const wire::FileChunk& chunk, std::int64_t now_ms);
  /// The connection is new: what was asked for is asked for again.
  void ask_again() { window_.start_again(there_); }

 private:
  void begin_next_file();
  void finish_file();

  const TaskCache& cache_;
  std::uint64_t task_;
  std::uint64_t attempt_;
  std::vector<StoredArtifact> files_;  ///< still to come; the last is the one that comes
  std::filesystem::path path_;
  Hasher hasher_;
  std::uint64_t there_ = 0;  ///< bytes of it
  ChunkWindow window_;
  std::string damaged_;
};

}  // namespace tetfarm
