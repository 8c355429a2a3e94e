/// From the sources that people write (mesh/job_file/plane_sources.h) to those that a mesh is
/// adapted to.
#pragma once

#include <string>
#include <vector>

#include "mesh/adaptation/metric_sources.h"
#include "mesh/job_file/plane_sources.h"

namespace tetfarm {

/// What a file of sources has. @throws UsageError for what is wrong in it, with its line; IoError.
PlaneSources read_plane_sources(const std::string& file);

MetricSources metric_sources_of(const std::vector<PlaneSource>& sources);

}  // namespace tetfarm
