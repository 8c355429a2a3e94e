/// What the command lines of a coordinator and of a worker say, in the words of those who run them.
/// Seconds become milliseconds.
#pragma once

#include <cstdint>

#include "cli/command_line.h"
#include "coordinator/server.h"
#include "worker/client.h"
#include "worker/machine.h"

namespace tetfarm {

/// Rounded down.
inline std::int64_t in_ms(double seconds) { return static_cast<std::int64_t>(seconds * 1000); }

/// It says on standard output where it listens, unless it is to be quiet.
CoordinatorOptions coordinator_options(const CoordinatorCommand& command);

/// A worker that is told not to use the store takes the coordinator's key from there all the same.
/// @param environment tells how long it may run, where the command does not.
WorkerOptions worker_options(const WorkerCommand& command, const Environment& environment,
                             std::int64_t now_wall_ms);

}  // namespace tetfarm
