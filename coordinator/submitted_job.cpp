#include "coordinator/submitted_job.h"

#include "base/error.h"
#include "base/job_name.h"
#include "mesh/job_file/job_file.h"

namespace tetfarm {

std::string checked_job_name(const wire::Submit& submit) {
  const JobFile job = parse_job_file(submit.job_toml(), "job.toml");
  if (!job.sources_file.empty()) {
    throw UsageError("`sources` names a file; a submitted job must contain its sources",
                     "job.toml");
  }
  const std::string& name = submit.name().empty() ? job.name : submit.name();
  const std::string problem = problem_with_job_name(name);
  if (!problem.empty()) throw UsageError("the job's name " + problem, "");
  return name;
}

}  // namespace tetfarm
