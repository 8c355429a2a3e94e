/// The complexity of a metric with sources on a mesh that may be far too coarse for them, and which
/// of them ask for anything.
///
/// The integral of the square root of the determinant, over pieces of the triangles that are small
/// where sources are near: triangles are halved across their longest edges, all of a size before
/// smaller ones, so that where their number ends it, they are coarse everywhere alike.
/// Departs from the thesis, which has no number of vertices. Cost: at most 100,000 pieces, each
/// O(sources).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/adaptation/metric_sources.h"
#include "mesh/planar/triangle_complex.h"

namespace tetfarm {

struct SourcedComplexity {
  double complexity = 0;
  /// Of each source, whether it asks somewhere for more than the background does.
  std::vector<std::uint8_t> acts;
};

/// `metrics`: the background, at the points of the triangles. @pre each is_metric
SourcedComplexity sourced_complexity(const TriangleComplex& complex,
                                     std::span<const Metric2> metrics,
                                     const MetricSources& sources);

}  // namespace tetfarm
