/// What a submission must be to become a job: nothing in it may fail later that can be seen now.
#pragma once

#include <string>

#include "proto/messages.pb.h"

namespace tetfarm {

/// The name of the job that is submitted, by itself or in its job file.
/// @throws UsageError when the job file cannot be read, "job.toml:line:column: …", or the name is
/// none that a job may have.
std::string checked_job_name(const wire::Submit& submit);

}  // namespace tetfarm
