#include <filesystem>

#include "base/clock.h"
#include "base/file_system.h"
#include "cli/commands.h"
#include "cli/converted_meshes.h"
#include "cli/coordinator_connection.h"
#include "cli/deliver_files.h"
#include "cli/job_outcome.h"
#include "cli/local_job.h"
#include "cli/typed_names.h"
#include "cli/unit_options.h"
#include "cli/wave_options.h"

namespace tetfarm {

ExitCode run_command(const RunOptions& options) {
  const std::int64_t start = steady_ms();
  listen_to_signals();
  const JobInput input = read_job(options);
  check_submittable(input);
  require_readable(input);
  tell_lengths(input.job, options.progress);
  tell_wave(input.job, options.progress);
  const std::filesystem::path folder = std::filesystem::absolute(options.output);
  const std::filesystem::path store = folder / ".tetfarm";
  make_folders(store);
  const FolderLock lock = lock_of_run(store, options.output);
  LocalOutcome outcome = run_locally(options, store, publish_job(ArtifactStore(store), input));
  if (!outcome.end) return report_stop(options, store, outcome);
  name_as_typed(*outcome.end, options, input);
  std::vector<std::filesystem::path> files = deliver_files(*outcome.end, store, folder);
  stop_listening();
  convert_mesh(*outcome.end, options.progress, files);
  const double seconds = static_cast<double>(steady_ms() - start) / 1000;
  return report_outcome(*outcome.end, {.files = std::move(files),
                                       .seconds = seconds,
                                       .json = options.json,
                                       .progress = options.progress});
}

}  // namespace tetfarm
