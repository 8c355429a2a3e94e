/// The feature edges of a surface, joined to curves that end in corners or are closed.
///
/// A vertex on a curve is between two of its edges; a corner ends any number of curves.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/remeshing/surface_features.h"

namespace tetfarm {

struct FeatureCurves {
  std::vector<std::int32_t> curve_of_edge;    ///< of each of features.edges; from 0, by first edge
  std::vector<std::int32_t> curve_of_vertex;  ///< of vertices on a curve; -1 of others
  std::int32_t count = 0;
};

/// Cost: O(vertices + edges).
FeatureCurves feature_curves(const SurfaceFeatures& features);

}  // namespace tetfarm
