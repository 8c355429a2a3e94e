/// How well a mesh fits its metric: lengths of edges, shapes of triangles.
///
/// Source: measures of the Unstructured Grid Adaptation Working Group (Ibanez et al., IMR 26,
/// 2017): lengths by both ends, quality 4 sqrt(3) area sqrt(det M) / sum l² by the metric of the
/// densest corner, 1 for an equilateral triangle. Cost: O(n log n).
#pragma once

#include <cstdint>
#include <span>

#include "mesh/metric/metric2.h"
#include "mesh/planar/plane_mesh.h"
#include "mesh/planar/triangle_complex.h"

namespace tetfarm {

struct MetricQuality {
  double unit_edges_percent = 100;  ///< of length 1/sqrt(2) to sqrt(2)
  double edge_length_min = 0;
  double edge_length_max = 0;
  double quality_min = 1;
  double quality_1percent = 1;  ///< so many triangles are worse
  double quality_mean = 1;
  double max_angle_deg = 0;  ///< as everybody measures it, without the metric
  Vec2 longest_at;           ///< the middle of the longest edge
  Vec2 worst_at;             ///< the middle of the triangle of the least quality
};

/// `metrics` at the points of the triangles. @pre at least one triangle
MetricQuality metric_quality(const TriangleComplex& complex, std::span<const Metric2> metrics);

}  // namespace tetfarm
