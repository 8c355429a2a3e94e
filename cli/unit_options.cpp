#include "cli/unit_options.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "worker/job_surface.h"

namespace tetfarm {

void set_scale(JobFile& job, const std::optional<double>& scale, const std::string& unit) {
  if (scale) {
    job.scale = *scale;
    job.unit.clear();
  }
  if (unit.empty()) return;
  const auto metres = metres_of(unit);
  if (!metres) throw UsageError("\"" + unit + "\" is no unit of length", "--unit");
  job.scale = *metres;
  job.unit = unit;
}

void tell_lengths(const JobFile& job, ProgressStyle style) {
  const std::string lengths = lengths_text(job);
  if (lengths.empty() || style == ProgressStyle::none) return;
  std::fprintf(stderr, "lengths    %s\n", lengths.c_str());
}

void put_lengths(const JobFile& job, nlohmann::ordered_json& json) {
  if (!job.unit.empty()) json["unit"] = "m";
  if (!job.unit.empty() || job.scale != 1) json["scale"] = job.scale;
}

}  // namespace tetfarm
