/// The files of a task of a worker that does not see the store: inputs come before it runs, outputs
/// go before its result is told.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "proto/messages.pb.h"
#include "worker/input_fetch.h"
#include "worker/output_upload.h"
#include "worker/task_cache.h"

namespace tetfarm {

class FileExchange {
 public:
  FileExchange(std::filesystem::path folder, std::uint64_t max_bytes)
      : folder_(std::move(folder)), max_bytes_(max_bytes) {}

  /// The worker's own store, where its tasks run. @throws IoError.
  const ArtifactStore& store() { return cache().store(); }

  /// Whether the disk has any; says so once when it has not.
  bool has_room();

  /// @throws IoError.
  void fetch_inputs(const wire::Assign& assign);
  /// Of a Done or a Failed. Inputs that the task found damaged are fetched anew the next time.
  /// @throws IoError.
  void send_outputs(const wire::Envelope& outcome);
  bool is_fetching() const { return fetch_ && !fetch_->is_complete(); }
  bool is_sending() const { return upload_ && !upload_->is_complete(); }
  /// An input that the coordinator has to make again; "": none.
  std::string damaged_input() const { return fetch_ ? fetch_->damaged() : ""; }

  /// What to send now. @throws IoError.
  std::vector<wire::Envelope> due(std::int64_t now_ms);
  /// FileChunk or FileStored. @throws IoError.
  void take(const wire::Envelope& message, std::int64_t now_ms);
  /// The connection is new.
  void ask_again();
  /// The attempt is over.
  void forget_task();

 private:
  TaskCache& cache();

  std::filesystem::path folder_;
  std::uint64_t max_bytes_;
  bool had_room_ = true;
  std::optional<TaskCache> cache_;
  std::optional<InputFetch> fetch_;
  std::optional<OutputUpload> upload_;
};

}  // namespace tetfarm
