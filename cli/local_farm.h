/// A coordinator and workers as processes of this machine, kept alive while a run lasts.
///
/// They speak the same protocol as everywhere, over an ipc socket in a folder of its own in /tmp (a
/// socket's path may be no longer than 107 bytes). Whoever dies is started again; when this process
/// dies, they die.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "cli/member_life.h"

namespace tetfarm {

struct FarmOptions {
  std::filesystem::path store;
  std::filesystem::path database;  ///< "": the store
  int workers = 1;                 ///< at most
  int first_workers = 1;           ///< that start at once
  double grace_s = 5;
  bool runs_solvers = false;  ///< of loops; a job file says what they are
};

class LocalFarm {
 public:
  /// Starts the coordinator and the first workers. Call from the thread that outlives the farm.
  /// @throws IoError.
  explicit LocalFarm(const FarmOptions& options);
  /// Kills what still runs.
  ~LocalFarm();
  LocalFarm(const LocalFarm&) = delete;
  LocalFarm& operator=(const LocalFarm&) = delete;

  const std::string& endpoint() const { return endpoint_; }

  /// Starts again what has died. @throws Error with the coordinator's own words when it cannot
  /// start.
  void look_after();

  /// Starts workers until there are as many as tasks, within the limit; none is ever let go.
  void grow(std::size_t tasks);

  /// Lets running tasks finish within the grace time, then ends everything. `hurry` is asked now
  /// and then: true ends it at once.
  void stop(bool (*hurry)());

 private:
  struct Member {
    pid_t process = -1;
    MemberLife life;
  };

  std::vector<std::string> coordinator_command() const;
  std::vector<std::string> worker_command() const;
  void start(Member& member, const std::vector<std::string>& command, const std::string& log);
  std::optional<int> reap(Member& member);
  bool wait_for_end(Member& member, std::int64_t until_ms, bool (*hurry)());

  FarmOptions options_;
  std::filesystem::path folder_;
  std::string endpoint_;
  Member coordinator_;
  std::vector<Member> workers_;
};

}  // namespace tetfarm
