#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/clock.h"
#include "base/file_system.h"
#include "base/printable_text.h"
#include "cli/commands.h"
#include "cli/deliver_files.h"
#include "cli/job_outcome.h"
#include "cli/local_job.h"
#include "cli/loop_input.h"
#include "json/json_line.h"
#include "json/reply_values.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

void tell_json(const wire::JobStatus& status, const std::vector<fs::path>& files, double seconds) {
  nlohmann::ordered_json json = {
      {"type", "loop"},
      {"job", status.job()},
      {"name", status.name()},
      {"state", status.state()},
      {"cycles", static_cast<std::uint64_t>(number_of(status, "cycles"))},
      {"vertices", static_cast<std::uint64_t>(number_of(status, "vertices"))},
      {"triangles", static_cast<std::uint64_t>(number_of(status, "triangles"))},
      {"solver_seconds", number_of(status, "task_solve_seconds")},
      {"adapt_seconds", number_of(status, "task_adapt_seconds")},
      {"attempts_lost", status.attempts_lost()},
      {"seconds", seconds},
      {"digest", text_of(status, "digest")},
      {"files", nlohmann::ordered_json::array()}};
  for (const fs::path& file : files) json["files"].push_back(file.string());
  std::printf("%s\n", json_line(json).c_str());
}

void tell(const wire::JobStatus& status, const fs::path& folder, double seconds) {
  std::printf("%s: %.0f cycles, %.0f vertices, %.0f triangles, %.1f s\n",
              printable(status.name()).c_str(), number_of(status, "cycles"),
              number_of(status, "vertices"), number_of(status, "triangles"), seconds);
  std::printf("solver          %.2f s, adaptation %.2f s\n",
              number_of(status, "task_solve_seconds"), number_of(status, "task_adapt_seconds"));
  std::printf("digest          %s\n", text_of(status, "digest").c_str());
  std::printf("meshes, solutions and cycles.csv lie in %s\n", printable(folder.string()).c_str());
}

RunOptions run_options(const LoopCommand& command) {
  RunOptions options;
  options.input = command.input;
  options.output = command.output;
  options.workers = command.workers;
  options.json = command.json;
  options.progress = command.progress;
  options.database = command.database;
  options.grace_s = command.grace_s;
  options.runs_solvers = true;
  return options;
}

}  // namespace

ExitCode loop_command(const LoopCommand& command) {
  const std::int64_t start = steady_ms();
  listen_to_signals();
  const LoopInput input = read_loop(command.input);
  const RunOptions options = run_options(command);
  const fs::path folder = fs::absolute(command.output);
  const fs::path store = folder / ".tetfarm";
  make_folders(store);
  const FolderLock lock = lock_of_run(store, command.output);
  const LocalOutcome outcome =
      run_locally(options, store, publish_loop(ArtifactStore(store), input));
  if (!outcome.end) return report_stop(options, store, outcome);
  const std::vector<fs::path> files = deliver_files(*outcome.end, store, folder);
  stop_listening();
  const double seconds = static_cast<double>(steady_ms() - start) / 1000;
  if (outcome.end->state() != "done") {
    return report_outcome(*outcome.end, {.files = files, .seconds = seconds, .json = command.json});
  }
  if (command.json) {
    tell_json(*outcome.end, files, seconds);
  } else {
    tell(*outcome.end, folder, seconds);
  }
  return ExitCode::ok;
}

}  // namespace tetfarm
