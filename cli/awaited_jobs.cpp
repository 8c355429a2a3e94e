#include "cli/awaited_jobs.h"

#include <algorithm>
#include <string_view>

#include "base/check.h"
#include "base/edit_distance.h"
#include "cli/did_you_mean.h"

namespace tetfarm {

std::string problem_with_awaited(const std::string& wanted, const std::vector<NamedJob>& known) {
  std::vector<std::string_view> numbers;
  std::vector<std::string_view> names;
  for (const NamedJob& job : known) {
    TF_CHECK(!job.job.empty());
    if (job.job == wanted) return {};
    numbers.push_back(job.job);
    names.push_back(job.name);
  }
  const std::string problem = "no job " + wanted + " to wait for";
  const std::string_view name = nearest_word(wanted, names);
  if (name.empty() || name != wanted) {
    const std::string of_number = did_you_mean(wanted, numbers);
    if (!of_number.empty() || name.empty()) return problem + of_number;
  }
  const auto newest = std::find_if(known.rbegin(), known.rend(),
                                   [&](const NamedJob& job) { return job.name == name; });
  TF_CHECK(newest != known.rend());
  const std::string also = name == wanted ? "" : " (" + newest->name + ")";
  return problem + "; did you mean " + in_ticks(newest->job) + also + "?";
}

}  // namespace tetfarm
