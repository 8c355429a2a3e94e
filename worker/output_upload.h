/// Brings the outputs of a task from the worker's own store to the coordinator, before the result
/// is told.
///
/// Without a socket: it says what to send, and is told how much of it is there, file by file
/// (file_send.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "proto/messages.pb.h"
#include "worker/file_send.h"
#include "worker/task_cache.h"

namespace tetfarm {

class OutputUpload {
 public:
  /// The outputs of a Done, or the evidence of a Failed. `cache` outlives it.
  OutputUpload(const TaskCache& cache, const wire::Envelope& outcome);

  bool is_complete() const { return files_.empty(); }

  /// What to send now. @throws IoError when a file cannot be read; CorruptFile as `take`.
  std::vector<wire::Envelope> due(std::int64_t now_ms);
  /// A file that has to be sent again is looked at first: one that was damaged here would be
  /// refused for ever. It is dropped from the cache. @throws CorruptFile, IoError.
  void take(const wire::FileStored& stored, std::int64_t now_ms);
  /// The connection is new.
  void ask_again();

 private:
  wire::Envelope offer() const;
  wire::Envelope chunk_at(std::uint64_t offset) const;
  void check_file() const;

  const TaskCache& cache_;
  std::uint64_t task_;
  std::uint64_t attempt_;
  std::vector<FileSend> files_;  ///< still to go; the last is the one that goes
};

}  // namespace tetfarm
