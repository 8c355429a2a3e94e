#include <cstdio>
#include <filesystem>

#include "base/error_with_help.h"
#include "base/file_system.h"
#include "cli/commands.h"
#include "cli/job_input.h"
#include "cli/job_template.h"

namespace tetfarm {
namespace {

const std::string job_file_ending = ".toml";
const std::string standard_output = "-";

JobInput input_of(const InitCommand& command) {
  if (command.surface.ends_with(job_file_ending)) {
    throw UsageError("is a job file already; give a surface", command.surface);
  }
  RunOptions options;
  options.input = command.surface;
  options.scale = command.scale;
  options.unit = command.unit;
  return read_job(options);
}

/// @throws UsageError, ErrorWithHelp when there cannot be a new job file of that name.
std::string output_of(const InitCommand& command, const JobInput& input) {
  std::string output = command.output.empty() ? input.job.name + job_file_ending : command.output;
  if (output == standard_output) return output;
  if (!output.ends_with(job_file_ending)) {
    throw UsageError("the name of a job file ends in .toml, and that of " + output + " does not",
                     "--output");
  }
  if (!command.force && std::filesystem::exists(output)) {
    throw ErrorWithHelp(ExitCode::usage, output + " exists already",
                        "give another file with -o, or --force to replace it");
  }
  return output;
}

/// Seen from the folder of the job file; a path that was given from the root on stays.
std::string surface_seen_from(const std::string& output, const std::string& surface) {
  namespace fs = std::filesystem;
  const fs::path folder = output == standard_output ? fs::path() : fs::path(output).parent_path();
  if (folder.empty() || fs::path(surface).is_absolute()) return surface;
  const fs::path from = fs::absolute(folder / "").lexically_normal();
  return fs::absolute(surface).lexically_normal().lexically_relative(from).string();
}

}  // namespace

ExitCode init_command(const InitCommand& command) {
  const JobInput input = input_of(command);
  const std::string output = output_of(command, input);
  ProposedJob proposed = propose_job(input);
  proposed.surface = surface_seen_from(output, input.path);
  if (output == standard_output) {
    std::printf("%s", job_template(proposed, "job.toml").c_str());
    return ExitCode::ok;
  }
  write_file_atomically(output, job_template(proposed, output));
  std::printf("%s\n", output.c_str());
  return ExitCode::ok;
}

}  // namespace tetfarm
