/// The coordinator's shell: sockets, clock, disk and log around the decisions of job_state.
///
/// One thread, one ROUTER socket for workers and clients alike. Each turn takes the messages that
/// wait, lets job_state decide, commits the changes in one transaction, and only then sends the
/// answers.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/error.h"

namespace tetfarm {

struct CoordinatorOptions {
  std::filesystem::path store;         ///< made when missing; the database wants a local disk
  std::vector<std::string> endpoints;  ///< "ipc:///path", or "tcp://127.0.0.1:*" for any free port
  std::int64_t heartbeat_ms = 1000;    ///< how often workers shall speak
  std::int64_t lease_ms = 10000;       ///< how long a silent worker keeps its task
  bool insecure = false;       ///< also bind addresses that other hosts can reach, in plain text
  bool log_to_stderr = false;  ///< everything, not only warnings
  bool handle_signals = true;  ///< SIGTERM and SIGINT stop it cleanly; off in a thread
  const std::atomic<bool>* stop = nullptr;  ///< looked at every 100 ms

  /// Called once, when clients and workers may connect, with the endpoints as bound.
  std::function<void(const std::vector<std::string>&)> on_listening;
};

/// The bound endpoints, one a line, for workers and clients that see the store. Absent while no
/// coordinator runs (it may be stale after a crash).
std::filesystem::path endpoints_file(const std::filesystem::path& store);

/// Runs until it is told to stop (signal or `stop`). All state lies in the store: killing it at any
/// instant and running it again goes on where it was.
/// @throws IoError when the store cannot be used, UsageError when an endpoint cannot be bound or
/// another coordinator holds the store.
ExitCode run_coordinator(const CoordinatorOptions& options);

}  // namespace tetfarm
