#include <filesystem>

#include "base/clock.h"
#include "base/file_system.h"
#include "cli/commands.h"
#include "cli/deliver_files.h"
#include "cli/job_outcome.h"
#include "cli/local_job.h"
#include "cli/loop_input.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

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
      run_locally(options, store, submission_of_loop(input, published_in(ArtifactStore(store))));
  if (!outcome.end) return report_stop(options, store, outcome);
  const std::vector<fs::path> files = deliver_files(*outcome.end, store, folder);
  stop_listening();
  const double seconds = static_cast<double>(steady_ms() - start) / 1000;
  return report_outcome(
      *outcome.end,
      {.files = files, .seconds = seconds, .json = command.json, .progress = command.progress});
}

}  // namespace tetfarm
