/// What the sub-commands do; each returns the exit code, and throws Error for main to print.
#pragma once

#include <filesystem>

#include "base/error.h"
#include "cli/command_line.h"

namespace tetfarm {

/// Coordinator and workers on this machine, until the mesh lies in the output folder. Stopped by
/// SIGINT or SIGTERM it ends at a checkpoint (75); the same command goes on from there.
ExitCode run_command(const RunOptions& options);

ExitCode check_command(const CheckOptions& options);
/// The same command with --store: rows against files. Never changes anything.
ExitCode check_store_command(const CheckOptions& options);
ExitCode gc_command(const GcCommand& command);

/// Reads and checks a surface, and writes a job file to start from.
ExitCode init_command(const InitCommand& command);

/// Reads and checks the surface, then prints the tree and the cost of each task.
ExitCode plan_command(const PlanCommand& command);
ExitCode quality_command(const QualityOptions& options);

/// `input` itself, or of the meshes in the folder the first by name, .vtkhdf (which knows the
/// sub-domains) before .ugrid; without any, the folder if it is a case of OpenFOAM.
/// @throws Error when there is none.
std::filesystem::path mesh_file(const std::filesystem::path& input);

/// Writes a mesh in another format.
ExitCode export_command(const ExportCommand& command);
/// Writes a surface in another format.
ExitCode convert_command(const ConvertCommand& command);
/// Remeshes a surface.
ExitCode surface_command(const SurfaceCommand& command);

/// Writes one page about a finished job, or about a mesh alone.
ExitCode report_command(const ReportCommand& command);

/// Draws a mesh into a PNG file.
ExitCode render_command(const RenderCommand& command);

/// Writes a closed surface that is made by formula.
ExitCode shape_command(const ShapeCommand& command);

/// Meshes the plane between closed loops.
ExitCode plane_command(const PlaneCommand& command);
/// Adapts a mesh of the plane.
ExitCode adapt_command(const AdaptCommand& command);
/// Cycles of solver and adaptation, on this machine, until their results lie in the output folder.
/// Stopped and gone on with as run_command.
ExitCode loop_command(const LoopCommand& command);
/// Brings a solution from one mesh of the plane to another.
ExitCode plane_transfer_command(const PlaneTransferCommand& command);

/// Prints how high the first layer on a flat plate has to be.
ExitCode spacing_command(const SpacingCommand& command);

// What is going on; of a running coordinator, or of a store at rest.
ExitCode status_command(const StatusCommand& command);
ExitCode jobs_command(const JobsCommand& command);
ExitCode tasks_command(const TasksCommand& command);
ExitCode workers_command(const WorkersCommand& command);
ExitCode events_command(const EventsCommand& command);
ExitCode logs_command(const LogsCommand& command);
/// Why a task waits or failed, where it ran, its place in the tree.
ExitCode explain_command(const ExplainCommand& command);

/// The farm on one screen until the key q is pressed; where there is no terminal, once.
ExitCode top_command(const TopCommand& command);

/// Serves the farm to browsers until SIGINT or SIGTERM.
ExitCode dashboard_command(const DashboardCommand& command);

/// Writes who did what when, for Perfetto.
ExitCode trace_command(const TraceCommand& command);
/// Copies the database into a file, and back.
ExitCode backup_command(const BackupCommand& command);
ExitCode restore_command(const RestoreCommand& command);

ExitCode submit_command(const SubmitCommand& command);
ExitCode wait_command(const WaitCommand& command);
ExitCode cancel_command(const CancelCommand& command);
ExitCode priority_command(const PriorityCommand& command);
ExitCode retry_command(const RetryCommand& command);
ExitCode drain_command(const DrainCommand& command);

ExitCode coordinator_command(const CoordinatorCommand& command);
ExitCode worker_command(const WorkerCommand& command);
/// Until it is ended by SIGINT or SIGTERM, which leaves the workers where they are.
ExitCode pool_command(const PoolCommand& command);
/// Makes keys, and says who may speak with a coordinator.
ExitCode keys_command(const KeysCommand& command);

/// Looks at a machine, its folders, keys and coordinator. Failed when something has to be mended.
ExitCode doctor_command(const DoctorCommand& command);

/// The program about itself.
ExitCode completion_command(const CompletionCommand& command);
ExitCode man_command(const ManCommand& command);
ExitCode version_command(const VersionCommand& command);

ExitCode task_command(const TaskCommand& command);
ExitCode task_host_command();

}  // namespace tetfarm
