#include "cli/awaited_jobs.h"

#include <algorithm>
#include <string_view>

#include "base/check.h"
#include "cli/did_you_mean.h"

namespace tetfarm {

std::string problem_with_awaited(const std::string& wanted, const std::vector<NamedJob>& known) {
  std::vector<std::string_view> numbers;
  for (const NamedJob& job : known) {
    TF_CHECK(!job.job.empty());
    if (job.job == wanted) return {};
    numbers.push_back(job.job);
  }
  const auto of_name = std::find_if(known.rbegin(), known.rend(),
                                    [&](const NamedJob& job) { return job.name == wanted; });
  const std::string problem = "no job " + wanted + " to wait for";
  if (of_name != known.rend()) return problem + "; did you mean " + in_ticks(of_name->job) + "?";
  return problem + did_you_mean(wanted, numbers);
}

}  // namespace tetfarm
