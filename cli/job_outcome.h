/// The end of a job as run and wait show it: files brought to their place, a report, an exit code.
#pragma once

#include <filesystem>

#include "base/error.h"
#include "proto/messages.pb.h"

namespace tetfarm {

struct OutcomeOptions {
  std::filesystem::path store;   ///< "": files are left where they are
  std::filesystem::path output;  ///< "": the same
  double seconds = 0;
  bool json = false;
};

bool has_ended(const wire::JobStatus& status);

/// @pre has_ended(status). @throws Error when the job failed (after its evidence was delivered).
ExitCode report_outcome(const wire::JobStatus& status, const OutcomeOptions& options);

}  // namespace tetfarm
