/// What the command lines of a coordinator and of a worker say, in the words of those who run them.
/// Seconds become milliseconds.
#pragma once

#include <cstdint>

#include "cli/command_line.h"
#include "coordinator/server.h"
#include "worker/client.h"
#include "worker/machine.h"

namespace tetfarm {

/// It says on standard output where it listens, unless it is to be quiet.
CoordinatorOptions coordinator_options(const CoordinatorCommand& command);

/// A worker that is told not to use the store takes the coordinator's key from there all the same.
/// @param environment tells how long it may run, where the command does not.
WorkerOptions worker_options(const WorkerCommand& command, const Environment& environment,
                             std::int64_t now_wall_ms);

}  // namespace tetfarm
