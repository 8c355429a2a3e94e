/// A program of somebody else's, run to its end: with a time limit, and with nothing left of it
/// when it is over or when this process dies.
///
/// The command is one of /bin/sh. It has a session and process group of its own, watched by a
/// process that kills the group when the process that called dies, however that comes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace tetfarm {

struct SolverCommand {
  std::string command;
  std::filesystem::path folder;                                ///< that it works in
  std::filesystem::path log;                                   ///< of what it says, on both outputs
  std::vector<std::pair<std::string, std::string>> variables;  ///< of its environment, besides ours
  std::int64_t time_limit_ms = 0;
};

struct SolverEnd {
  bool is_overdue = false;  ///< it was killed for its time limit
  int exit_code = 0;
  int signal = 0;  ///< that ended it; 0: none
};

/// Calls `tick` several times a second. @throws IoError.
SolverEnd run_solver(const SolverCommand& solver, const std::function<void()>& tick);

}  // namespace tetfarm
