/// The job file that `init` writes: settings with words on each, most of them commented out.
///
/// Source: docs/job_file.md. A line that begins with # and a blank is a remark; one that begins
/// with # and anything else is a setting that is not in force. Adjacent ones belong together and
/// may each have a second #: those are left for later when the first # of all of them is taken
/// away. Whatever is taken away in this way leaves a job file that is valid.
#pragma once

#include <string>

#include "cli/proposed_job.h"

namespace tetfarm {

/// @param file what the job file will be called, for the commands that it names. As it is written
/// it says the same as no job file at all. @throws UsageError when no job file can name the
/// surface.
std::string job_template(const ProposedJob& proposed, const std::string& file);

}  // namespace tetfarm
