#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <string_view>

#include "base/error.h"
#include "cli/commands.h"
#include "cli/error_help.h"
#include "cli/progress_lines.h"
#include "cli/terminal.h"
#include "json/job_json.h"

namespace tetfarm {
namespace {

/// Whether the command asked for JSON; looked up before it is parsed, as parsing may be what fails.
bool wants_json(int argc, char** argv) {
  return std::any_of(argv, argv + argc,
                     [](const char* word) { return std::string_view(word) == "--json"; });
}

CommandEnd failed_end(const Error& error, const std::string& help) {
  CommandEnd end;
  end.state = "failed";
  end.exit_code = static_cast<int>(error.code());
  end.message = error.what();
  end.help = help;
  return end;
}

int complain(const Error& error, int argc, char** argv) {
  const int code = static_cast<int>(error.code());
  if (wants_json(argc, argv)) std::printf("%s\n", error_json(error.what(), code).c_str());
  const std::string help = help_for(error, argc > 1 ? argv[1] : "");
  if (asks_for_json_progress(argc, argv)) {
    std::fflush(stdout);  // the end is the last, also where both go to one place
    tell_end(ProgressStyle::json, failed_end(error, help));
    return code;
  }
  std::fputs(complaint(error.what(), help).c_str(), stderr);
  return code;
}

struct Execute {
  ExitCode operator()(const NothingToDo& /*nothing*/) const { return ExitCode::ok; }
  ExitCode operator()(const RunOptions& options) const { return run_command(options); }
  ExitCode operator()(const CheckOptions& options) const { return check_command(options); }
  ExitCode operator()(const InitCommand& command) const { return init_command(command); }
  ExitCode operator()(const GcCommand& command) const { return gc_command(command); }
  ExitCode operator()(const PlanCommand& command) const { return plan_command(command); }
  ExitCode operator()(const QualityOptions& options) const { return quality_command(options); }
  ExitCode operator()(const ExportCommand& command) const { return export_command(command); }
  ExitCode operator()(const ConvertCommand& command) const { return convert_command(command); }
  ExitCode operator()(const SurfaceCommand& command) const { return surface_command(command); }
  ExitCode operator()(const RenderCommand& command) const { return render_command(command); }
  ExitCode operator()(const ShapeCommand& command) const { return shape_command(command); }
  ExitCode operator()(const SpacingCommand& command) const { return spacing_command(command); }
  ExitCode operator()(const PlaneCommand& command) const { return plane_command(command); }
  ExitCode operator()(const AdaptCommand& command) const { return adapt_command(command); }
  ExitCode operator()(const LoopCommand& command) const { return loop_command(command); }
  ExitCode operator()(const PlaneTransferCommand& command) const {
    return plane_transfer_command(command);
  }
  ExitCode operator()(const StatusCommand& command) const { return status_command(command); }
  ExitCode operator()(const WaitCommand& command) const { return wait_command(command); }
  ExitCode operator()(const CancelCommand& command) const { return cancel_command(command); }
  ExitCode operator()(const PriorityCommand& command) const { return priority_command(command); }
  ExitCode operator()(const RetryCommand& command) const { return retry_command(command); }
  ExitCode operator()(const DrainCommand& command) const { return drain_command(command); }
  ExitCode operator()(const SubmitCommand& command) const { return submit_command(command); }
  ExitCode operator()(const CoordinatorCommand& command) const {
    return coordinator_command(command);
  }
  ExitCode operator()(const WorkerCommand& command) const { return worker_command(command); }
  ExitCode operator()(const PoolCommand& command) const { return pool_command(command); }
  ExitCode operator()(const KeysCommand& command) const { return keys_command(command); }
  ExitCode operator()(const DoctorCommand& command) const { return doctor_command(command); }
  ExitCode operator()(const JobsCommand& command) const { return jobs_command(command); }
  ExitCode operator()(const TasksCommand& command) const { return tasks_command(command); }
  ExitCode operator()(const WorkersCommand& command) const { return workers_command(command); }
  ExitCode operator()(const EventsCommand& command) const { return events_command(command); }
  ExitCode operator()(const LogsCommand& command) const { return logs_command(command); }
  ExitCode operator()(const ExplainCommand& command) const { return explain_command(command); }
  ExitCode operator()(const TopCommand& command) const { return top_command(command); }
  ExitCode operator()(const DashboardCommand& command) const { return dashboard_command(command); }
  ExitCode operator()(const TraceCommand& command) const { return trace_command(command); }
  ExitCode operator()(const ReportCommand& command) const { return report_command(command); }
  ExitCode operator()(const BackupCommand& command) const { return backup_command(command); }
  ExitCode operator()(const RestoreCommand& command) const { return restore_command(command); }
  ExitCode operator()(const CompletionCommand& command) const {
    return completion_command(command);
  }
  ExitCode operator()(const ManCommand& command) const { return man_command(command); }
  ExitCode operator()(const VersionCommand& command) const { return version_command(command); }
  ExitCode operator()(const TaskCommand& command) const { return task_command(command); }
  ExitCode operator()(const TaskHostCommand& /*command*/) const { return task_host_command(); }
};

}  // namespace
}  // namespace tetfarm

int main(int argc, char** argv) {
  using namespace tetfarm;
  guard_terminal();
  if (asks_for_json_progress(argc, argv)) tell_messages_in_json();
  try {
    return static_cast<int>(std::visit(Execute{}, parse_command_line(argc, argv)));
  } catch (const Error& error) {
    return complain(error, argc, argv);
  } catch (const std::bad_alloc&) {
    return complain(Error(ExitCode::out_of_resources, "out of memory"), argc, argv);
  } catch (const std::filesystem::filesystem_error& error) {
    const std::string path = error.path1().empty() ? "a path" : error.path1().string();
    return complain(Error(ExitCode::failed, path + ": " + error.code().message()), argc, argv);
  } catch (const std::exception& error) {
    return complain(Error(ExitCode::failed, error.what()), argc, argv);
  }
}
