/// Brings the inputs of a task from the coordinator into the worker's own store, chunk by chunk.
///
/// Without a socket: it says what to send, and is told what came, file by file (file_receive.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "proto/messages.pb.h"
#include "worker/file_receive.h"
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
  void ask_again() {
    if (receive_) receive_->ask_again();
  }

 private:
  void begin_next_file();
  void finish_file();

  const TaskCache& cache_;
  std::uint64_t task_;
  std::uint64_t attempt_;
  std::vector<StoredArtifact> files_;  ///< still to come; the last is the one that comes
  std::optional<FileReceive> receive_;
  std::string damaged_;
};

}  // namespace tetfarm
