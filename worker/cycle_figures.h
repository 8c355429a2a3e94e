/// What the mesh of a cycle is like, as a row of the table of cycles that a loop delivers.
#pragma once

#include <cstdint>
#include <string>

#include "mesh/adaptation/adapt_to_metric.h"
#include "mesh/adaptation/metric_quality.h"

namespace tetfarm {

/// The first line of the table, with its end.
std::string cycle_figures_head();

/// Of the first mesh, which was adapted to nothing.
std::string cycle_figures(const PlaneMesh& mesh);

/// @param gain what the integral of the first field has gained on the way to the mesh, as a share
/// of that of its absolute values.
std::string cycle_figures(const PlaneMesh& mesh, const MetricQuality& quality, double gain);

}  // namespace tetfarm
