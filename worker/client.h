/// A worker's side of the protocol (proto/protocol.md): asks for tasks, runs one at a time in a
/// child process, and tells the coordinator what became of it.
///
/// It never gives up on the coordinator: when that is silent for a lease the worker connects anew,
/// and keeps its running task and any result that has not been accepted.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "proto/peer_security.h"

namespace tetfarm {

struct WorkerOptions {
  std::string endpoint;         ///< "tcp://host:5555", "ipc:///path"
  KeyFiles keys;                ///< read again at each connection
  std::filesystem::path store;  ///< the store's folder, as this machine sees it; "": not
  std::filesystem::path cache;  ///< for files when it does not see the store
  std::uint64_t cache_bytes = std::uint64_t{10} << 30U;  ///< that are kept from task to task
  std::vector<std::string> task_command;     ///< the child's program; its store is appended
  std::vector<std::string> host_command;     ///< a TaskHost for it; empty: none
  std::uint64_t memory_bytes = 0;            ///< for its tasks; 0: what the machine has
  std::string tag;                           ///< of the pool that submitted it: "POOL/JOB"
  std::uint64_t pool_memory_bytes = 0;       ///< the most that another of its pool can have
  bool runs_solvers = false;                 ///< of loops: programs that job files name
  std::int64_t ends_in_ms = 0;               ///< until its batch system ends it; 0: not known
  std::int64_t grace_ms = 30'000;            ///< how long a running task may go on after SIGTERM
  bool handle_signals = true;                ///< off in a thread
  const std::atomic<bool>* drain = nullptr;  ///< looked at every 10 ms; as SIGTERM
};

/// Runs until it is drained: by SIGTERM, SIGINT, SIGHUP, SIGUSR1, SIGUSR2 (as batch systems send
/// before they take a machine away), by the coordinator, or by itself a grace time before it is
/// ended. A second signal hands the task back at
/// once.
/// @throws Error when the coordinator refuses this worker, or does not know its key.
ExitCode run_worker(const WorkerOptions& options);

}  // namespace tetfarm
