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
  std::filesystem::path store;         ///< made when missing; may lie on a network file system
  std::filesystem::path database;      ///< folder of the database, on a local disk; "": the store
  std::filesystem::path keys;          ///< folder of the keys; "": see find_keys
  std::vector<std::string> endpoints;  ///< "ipc:///path", or "tcp://127.0.0.1:*" for any free port
  std::vector<std::filesystem::path> allowed_roots;  ///< folders that jobs may name surfaces in
  std::int64_t heartbeat_ms = 1000;                  ///< how often workers shall speak
  std::int64_t lease_ms = 10000;                     ///< how long a silent worker keeps its task
  std::size_t max_connections = 16384;
  std::size_t max_workers = 10'000;
  int handshake_ms = 10'000;  ///< a connection that takes longer to say who it is is closed
  bool insecure = false;      ///< every address in plain text, whoever can reach it
  std::int64_t task_limit_ms = 3'600'000;         ///< at least; see FarmRules::least_limit_ms
  std::int64_t first_task_limit_ms = 86'400'000;  ///< see FarmRules::unknown_limit_ms
  /// Where people and Prometheus look ("127.0.0.1:8080"); "": nowhere. Beyond loopback only with a
  /// file that holds a token.
  std::string http_address = {};
  std::filesystem::path http_token = {};
  /// A program of the administrator's that is started when a job has ended (job_end_program.h); "":
  /// none.
  std::filesystem::path on_job_end = {};
  std::int64_t keep_ms = 0;       ///< how long jobs are kept that have ended; 0: for ever
  std::size_t jobs_per_user = 0;  ///< that may run and wait at once; 0: any number
  bool one_job = false;           ///< serves one run: a submission may replace the jobs before it
  bool log_to_stderr = false;     ///< everything, not only warnings
  bool handle_signals = true;     ///< SIGTERM and SIGINT stop it cleanly; off in a thread
  const std::atomic<bool>* stop = nullptr;  ///< looked at every 100 ms

  /// Called once, when clients and workers may connect, with the endpoints as bound.
  std::function<void(const std::vector<std::string>&)> on_listening;
  /// The same with the address of HTTP, when there is one.
  std::function<void(const std::string&)> on_http;
};

/// The bound endpoints, one a line, for workers and clients that see the store. Absent while no
/// coordinator runs (it may be stale after a crash).
std::filesystem::path endpoints_file(const std::filesystem::path& store);

/// Runs until it is told to stop (signal or `stop`). All state lies in the store: killing it at any
/// instant and running it again goes on where it was.
///
/// With a coordinator's key in the folder of keys, all tcp endpoints are encrypted and take
/// authorised keys only; which folder that is, is told to the log. Without one, only ipc and
/// loopback addresses may be bound, unless `insecure`. Told to $NOTIFY_SOCKET, when systemd names
/// one. ipc is always plain: its folder's permissions say who may come in. The process's umask
/// takes all rights from others than the group, but for one_job.
/// @throws IoError when the store cannot be used, UsageError when an endpoint cannot be bound,
/// the keys are not in order, another coordinator holds the store, or the database belongs to
/// another store or would lie on a network file system.
ExitCode run_coordinator(const CoordinatorOptions& options);

}  // namespace tetfarm
