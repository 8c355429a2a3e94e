/// A program of the administrator's, run to its end or to a limit of time.
///
/// It is started without a shell and without arguments, in a process group of its own, with nothing
/// open but its output, of which the end is kept for the log, and with the signals as a program
/// expects them. Units: milliseconds.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tetfarm {

struct LimitedProgram {
  std::filesystem::path path;
  std::vector<std::string> environment;  ///< "NAME=VALUE", all of it
  std::int64_t limit_ms = 60'000;
  std::int64_t grace_ms = 2'000;  ///< between SIGTERM and SIGKILL, for the whole group
};

/// Waits for it. "" when it ended with 0, else what went wrong and what it said last, in one line.
/// @param stop becomes true when it is to end at once: as at the limit
/// @pre no other thread waits for children of this process.
std::string run_limited(const LimitedProgram& program, const std::atomic<bool>& stop);

}  // namespace tetfarm
