/// Adapts a mesh of the plane to a metric: afterwards its edges have unit length, as nearly as the
/// metric lets them.
///
/// Source: thesis 3.3.3, edge by edge; departs: edges are compared with unit length, and with the
/// mean of the present mesh (equation 16) only where that is asked for (mean_length_rules.h).
/// Coarsening comes first, then nodes on long edges, then sweeps of swapping, smoothing, collapsing
/// and dividing, and last the edges and triangles that are still the worst.
/// Determinism: the result depends on the input alone. Cost: O(nodes of input and result).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/adaptation/ellipse_cavity.h"
#include "mesh/adaptation/mean_length_rules.h"
#include "mesh/adaptation/metric_mesh.h"
#include "mesh/adaptation/metric_sources.h"
#include "mesh/adaptation/patch_curve.h"
#include "mesh/planar/plane_mesh.h"

namespace tetfarm {

/// What lengths of edges are compared with.
enum class EdgeRules {
  unit_length,
  mean_length  ///< of the edges of the mesh that is given: thesis 3.3.3
};

struct AdaptationOptions {
  EdgeRules rules = EdgeRules::unit_length;
  MeanLengthRules by_mean = {};  ///< of EdgeRules::mean_length
  CavityOptions cavity;
  /// Where two boundary edges turn by more, their node is a corner.
  double corner_angle_deg = 30;
  /// Of patches; those of others are splines through the nodes. @pre the nodes lie on them
  /// (nodes_on_curves.h)
  std::vector<PatchCurve> curves = {};
  /// What they ask for is intersected with the metrics, exactly where each node comes to be; with
  /// EdgeRules::unit_length alone. They outlive the call.
  const MetricSources* sources = nullptr;
  int sweeps = 8;
  std::int64_t max_triangles = 100'000'000;
};

struct AdaptationResult {
  PlaneMesh mesh;
  std::vector<Metric2> metrics;  ///< at its points; by mean length, such that this is 1
  // By the metrics that were given; by unit length 0.
  double mean_length_before = 0;
  double mean_length_after = 0;
};

/// `metrics` at the points of `mesh`.
/// @throws InvalidInput when the mesh is no valid triangulation, or a metric is none: with the
/// number of the entity in the file (from 1) and where it is; when there would be too many
/// triangles.
AdaptationResult adapt_mesh(const PlaneMesh& mesh, std::span<const Metric2> metrics,
                            const AdaptationOptions& options = {});

/// The same of a mesh and metrics that are checked. `complex`: checked_complex() of the mesh.
AdaptationResult adapt_checked_mesh(const PlaneMesh& mesh, const TriangleComplex& complex,
                                    std::vector<Metric2> metrics, const AdaptationOptions& options);

}  // namespace tetfarm
