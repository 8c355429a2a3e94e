/// The end of a run in the words of who typed it.
#pragma once

#include "cli/command_line.h"
#include "cli/job_input.h"
#include "proto/messages.pb.h"

namespace tetfarm {

/// The first task names the surface without its folder, and options by the keys of a job file: in
/// the message of a job that failed there they are named as the user did.
void name_as_typed(wire::JobStatus& end, const RunOptions& options, const JobInput& input);

}  // namespace tetfarm
