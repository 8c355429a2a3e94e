#include "cli/output_formats.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "base/error.h"
#include "cli/did_you_mean.h"
#include "mesh/job_file/job_formats.h"

namespace tetfarm {
namespace {

[[noreturn]] void refuse(const std::string& name) {
  std::string known;
  for (const std::string_view format : job_output_formats()) {
    known += (known.empty() ? "" : ", ") + std::string(format);
  }
  const auto formats = job_output_formats();
  const std::string meant = did_you_mean(name, {formats.begin(), formats.end()});
  throw UsageError("unknown format" + (meant.empty() ? "; known are " + known : meant),
                   "--format " + name);
}

}  // namespace

void require_known_formats(const std::vector<std::string>& formats) {
  const auto known = job_output_formats();
  std::set<std::string> seen;
  for (const std::string& name : formats) {
    if (std::find(known.begin(), known.end(), name) == known.end()) refuse(name);
    if (!seen.insert(name).second) throw UsageError("is given twice", "--format " + name);
  }
}

}  // namespace tetfarm
