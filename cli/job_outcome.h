/// The end of a job as run and wait show it: a report and an exit code.
#pragma once

#include <filesystem>
#include <vector>

#include "base/error.h"
#include "cli/command_line.h"
#include "proto/messages.pb.h"

namespace tetfarm {

struct OutcomeOptions {
  std::vector<std::filesystem::path> files;  ///< that were brought
  double seconds = 0;
  bool json = false;
  ProgressStyle progress = ProgressStyle::none;
};

bool has_ended(const wire::JobStatus& status);

/// With progress in JSON it tells the end of the command, too.
/// @pre has_ended(status). @throws Error when the job failed.
ExitCode report_outcome(const wire::JobStatus& status, const OutcomeOptions& options);

}  // namespace tetfarm
