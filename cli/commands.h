/// What the sub-commands do; each returns the exit code, and throws Error for main to print.
#pragma once

#include "base/error.h"
#include "cli/command_line.h"

namespace tetfarm {

/// Coordinator and workers on this machine, until the mesh lies in the output folder. Stopped by
/// SIGINT or SIGTERM it ends at a checkpoint (75); the same command goes on from there.
ExitCode run_command(const RunOptions& options);

ExitCode check_command(const CheckOptions& options);
ExitCode quality_command(const QualityOptions& options);

/// Writes a closed surface that is made by formula.
ExitCode shape_command(const ShapeCommand& command);

ExitCode status_command(const StatusCommand& command);
ExitCode submit_command(const SubmitCommand& command);
ExitCode wait_command(const WaitCommand& command);
ExitCode cancel_command(const CancelCommand& command);

ExitCode coordinator_command(const CoordinatorCommand& command);
ExitCode worker_command(const WorkerCommand& command);
ExitCode task_command(const TaskCommand& command);

}  // namespace tetfarm
