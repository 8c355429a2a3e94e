#include "worker/metric_source_file.h"

#include "base/file_system.h"
#include "mesh/job_file/toml_limits.h"

namespace tetfarm {

PlaneSources read_plane_sources(const std::string& file) {
  return parse_plane_sources(read_part_of_file(file, 0, largest_job_file + 1), file);
}

MetricSources metric_sources_of(const std::vector<PlaneSource>& sources) {
  std::vector<MetricSource> all;
  for (const PlaneSource& s : sources) {
    MetricSource source;
    source.from = {s.from[0], s.from[1]};
    source.to = {s.to[0], s.to[1]};
    source.along = s.sizes[0];
    source.across = s.sizes[1];
    source.angle_deg = s.angle_deg;
    source.radius = s.radius;
    source.growth = s.growth;
    all.push_back(source);
  }
  return MetricSources(all);
}

}  // namespace tetfarm
