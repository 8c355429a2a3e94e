/// The jobs that `submit --after` names: whether they are there, and what was probably meant.
#pragma once

#include <string>
#include <vector>

namespace tetfarm {

/// A job as a person may know it.
struct NamedJob {
  std::string job;   ///< "job-7"
  std::string name;  ///< "wing"
};

/// "" when `wanted` is the number of one of the jobs, job-7. Otherwise what is wrong, with the job
/// of that name, the newest of several, or the number or name that is nearest.
/// @param known by rising number
std::string problem_with_awaited(const std::string& wanted, const std::vector<NamedJob>& known);

}  // namespace tetfarm
