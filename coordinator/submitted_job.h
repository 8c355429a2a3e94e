/// What a submission must be to become a job: nothing in it may fail later that can be seen now.
#pragma once

#include <string>

#include "coordinator/decisions/job_state.h"
#include "proto/messages.pb.h"

namespace tetfarm {

/// The name of the job that is submitted, by itself or in its job file.
/// @throws UsageError when the job file cannot be read, "job.toml:line:column: …", or the name is
/// none that a job may have.
std::string checked_job_name(const wire::Submit& submit);

/// Whether the job is meshed from another surface than the given one. @pre checked_job_name has
/// read its job file, which is none of a loop.
bool is_remeshed(const wire::Submit& submit);

/// Puts what the first task of an adaptation loop is given into the submission.
/// @pre is_loop_job(submit.job_toml()).
/// @throws UsageError as before, and when an input is missing or is none that a loop has.
void add_first_cycle(const wire::Submit& submit, const TaskFile& job_file, Submission& submission);

}  // namespace tetfarm
