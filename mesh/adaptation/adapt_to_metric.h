/// Adapts a mesh to a wish: a metric at its nodes, limits, and a number of vertices.
///
/// Source: thesis 3.3, with a number of vertices that it has no way to ask for. How many vertices a
/// unit mesh gets follows from its complexity within a few percent, more where much of it is
/// boundary: where the first mesh misses the number, the scale is corrected by what it came to.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesh/adaptation/adapt_mesh.h"
#include "mesh/adaptation/metric_scaling.h"

namespace tetfarm {

struct AdaptationWish {
  std::vector<Metric2> metrics;  ///< at the points of the mesh
  MetricLimits limits;
  std::optional<std::int64_t> vertices;  ///< else the metrics are taken as they are
  std::string metric_name = {};          ///< of their file, for messages
};

struct AdaptedMesh {
  AdaptationResult result;
  ScaledMetric asked;  ///< on the nodes of the mesh before; without its metrics
};

/// `complex`: checked_complex() of the mesh, whose own triangles are not looked at and may be gone.
/// @throws InvalidInput as adapt_mesh and scaled_to do.
AdaptedMesh adapt_to_metric(const PlaneMesh& mesh, const TriangleComplex& complex,
                            AdaptationWish wish, const AdaptationOptions& options = {});

}  // namespace tetfarm
