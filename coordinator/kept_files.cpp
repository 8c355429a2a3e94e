#include "coordinator/kept_files.h"

#include "base/error.h"
#include "mesh/job_file/job_file.h"
#include "mesh/job_file/loop_job.h"

namespace tetfarm {

bool keeps_all_files(const JobRow& job) {
  try {
    if (is_loop_job(job.job_toml, "job.toml")) return true;
    return keeps_all_files(parse_job_file(job.job_toml, "job.toml"));
  } catch (const Error&) {
    return true;
  }
}

}  // namespace tetfarm
