/// Batch systems: what is submitted, and how their answers are read. Text in, text out; nothing is
/// run here (pool/run_command.h does).
///
/// A job runs one worker. It is found again by its name, `tetfarm-POOL-4096M`, which also tells its
/// size; whoever starts the same pool anew goes on with its jobs. A worker tells the coordinator
/// its tag, POOL/JOB, so that jobs and workers can be matched.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pool/decisions.h"

namespace tetfarm {

struct PoolSettings {
  std::string name;     ///< of the pool: letters, digits, _ and -
  std::string user;     ///< whose jobs are listed
  std::string program;  ///< `tetfarm`, as the workers' machines see it
  std::string coordinator;
  std::string store;  ///< as the workers' machines see it; "": files come over the connection
  std::string cache;  ///< for those that do, on the workers' machines; "": the worker's own choice
  std::string key;    ///< of the workers, "": none
  std::string coordinator_key;  ///< "": that of the store
  std::string logs = ".";       ///< folder of what workers say
  std::int64_t walltime_s = 8 * 3600;
  std::int64_t grace_s = 60;         ///< to finish a task in, after the signal and before the end
  std::uint64_t most_bytes = 0;      ///< of the largest job of the pool
  std::vector<std::string> options;  ///< lines for the script, or for the submit description
  std::vector<std::string> hosts;    ///< of ssh: "name" or "name:slots"
  bool runs_solvers = false;         ///< of adaptation loops, which job files name
};

/// A program with its arguments, and what it reads on standard input.
struct ShellCommand {
  std::vector<std::string> words;
  std::string input;

  friend bool operator==(const ShellCommand&, const ShellCommand&) = default;
};

struct CommandOutcome {
  int code = -1;  ///< exit code; -1: killed, or did not end in time
  std::string out;
  std::string err;
};

class BatchSystem {
 public:
  virtual ~BatchSystem() = default;

  /// What submits `order`: one command, or none where no host has room for it; several where hosts
  /// are asked one by one. `jobs` are those that are there already.
  virtual std::vector<ShellCommand> submit(const WorkerOrder& order,
                                           const std::vector<PoolJob>& jobs) const = 0;
  /// The jobs that a submission made. Empty: it failed, or its answer cannot be understood.
  virtual std::vector<std::string> submitted(const WorkerOrder& order,
                                             const CommandOutcome& outcome) const = 0;
  /// What lists this pool's jobs; their answers are read one by one.
  virtual std::vector<ShellCommand> list() const = 0;
  /// Nothing: it failed, or cannot be understood.
  virtual std::optional<std::vector<PoolJob>> listed(const CommandOutcome& outcome) const = 0;
  virtual std::vector<ShellCommand> cancel(const std::vector<std::string>& jobs) const = 0;
};

/// `system`: slurm, condor, lsf, ge, ssh or local. @throws UsageError for what a script cannot
/// hold: a name, a path or an option with a line break in it.
std::unique_ptr<BatchSystem> make_batch_system(const std::string& system,
                                               const PoolSettings& settings);

}  // namespace tetfarm
