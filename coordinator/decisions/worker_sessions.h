/// The workers that are here: their terms, what each holds, who waits for a task, how much memory
/// there is.
///
/// A worker is one connection; a process that connects anew is another worker for as long as its
/// earlier connection is here. Invariants, checked by validate():
///  1. A worker holds only an attempt that runs, that is its own and of its process.
///  2. Who waits for a task is here, holds nothing, and does not drain.
///  3. A process is named for at most one worker, which is here and of that process.
///  4. The memory of each worker is counted once.
/// Units: times in milliseconds. Cost: O(log workers), where it is not said.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "coordinator/decisions/worker_process.h"
#include "store/rows.h"

namespace tetfarm {

/// What a worker says of itself each time that it says Hello.
struct SessionTerms {
  WorkerProcess process;
  std::string tag = {};  ///< of the pool that brought it
  bool shares_memory = true;
  std::int64_t ends_ms = 0;  ///< 0: not known
  bool runs_solvers = false;
};

struct WorkerSession {
  WorkerRow row;
  SessionTerms terms;
  AttemptId attempt;  ///< running there, 0: none
  bool drains = false;
  std::int64_t heard_ms = 0;
  std::uint64_t reach_bytes = 0;  ///< its memory, or what its pool can bring
};

class WorkerSessions {
 public:
  /// Of each host whose workers share its memory: what running attempts were given of it.
  using HostMemory = std::map<std::string, std::uint64_t>;
  using All = std::map<WorkerId, WorkerSession>;

  // Workers come, speak and leave. @pre where one is named: it is here, but for arrive().
  void arrive(const WorkerRow& row, std::uint64_t reach_bytes);
  void introduce(WorkerId worker, const SessionTerms& terms, std::int64_t now_ms);
  /// Makes it the newest connection of its process; the one that was so far comes back. @pre its
  /// process can be told from others: it has a nonce.
  std::optional<WorkerId> take_seat(WorkerId worker);
  void hear(WorkerId worker, std::int64_t now_ms) { sessions_.at(worker).heard_ms = now_ms; }
  /// @pre it holds nothing.
  WorkerRow leave(WorkerId worker);

  // What they do.
  /// It asks for a task. @pre it holds none, and does not drain.
  void wait(WorkerId worker) { idle_.insert(worker); }
  void hold(WorkerId worker, AttemptId attempt);
  /// It holds the attempt no more. Nothing happens when it is not here, or holds another one.
  void let_go(WorkerId worker, AttemptId attempt);
  /// It gets no more tasks.
  void drain(WorkerId worker);

  bool has(WorkerId worker) const { return sessions_.contains(worker); }
  /// @pre it is here.
  const WorkerSession& at(WorkerId worker) const { return sessions_.at(worker); }
  const All& all() const { return sessions_; }
  /// That asked for a task and were given none.
  const std::set<WorkerId>& idle() const { return idle_; }
  /// Those of which nothing was heard since. Cost: O(workers).
  std::vector<WorkerId> silent_since(std::int64_t then_ms) const;
  /// When the one was heard of which nothing was heard for longest; nothing when none is here.
  /// Cost: O(workers).
  std::optional<std::int64_t> longest_silent_ms() const;

  /// What a worker may use at most, of those that are here or that a pool of theirs can bring; 0
  /// when that is not known.
  std::uint64_t largest_memory() const { return memories_.empty() ? 0 : *memories_.rbegin(); }
  /// Attempts without a session are of workers that have not come back after a restart: they run
  /// all the same. Whether such a worker has memory of its own is not known before it is back.
  /// Cost: O(running attempts).
  HostMemory used_memory(const std::map<AttemptId, AttemptRow>& running) const;
  /// What is left of a worker's memory: its own, or the host's, less what runs there already.
  /// @pre it is here.
  std::uint64_t free_memory(WorkerId worker, const HostMemory& used) const;

  /// The broken invariants, in words; empty when all is well. Cost: O(workers).
  std::vector<std::string> validate(const std::map<AttemptId, AttemptRow>& running) const;

 private:
  void leave_seat(WorkerId worker);
  void find_broken_session(const WorkerSession& session,
                           const std::map<AttemptId, AttemptRow>& running,
                           std::vector<std::string>& broken) const;

  All sessions_;
  std::set<WorkerId> idle_;
  std::map<WorkerProcess, WorkerId> process2worker_;  ///< its newest connection
  std::multiset<std::uint64_t> memories_;             ///< of the workers, or of their pools
};

}  // namespace tetfarm
