/// The thesis's own rules of adaptation: edges are compared with the mean length of those of the
/// mesh that is given, whatever the metric says of their number.
///
/// Source: thesis 3.3.3, equation 16 (whose two rules are printed the wrong way round): edges
/// longer than 1.2 mean lengths get a node at their middle, edges shorter than 0.8 go. Departs:
/// lengths are those of metric_mesh.h and not by equation 15; of an edge that goes one end stays, a
/// node of the boundary comes on its curve, and nothing is done that would only be undone: an edge
/// that goes leaves none that is too long. The mean is taken once: from a mesh that changes it
/// would follow what it is to steer. Cost: O(nodes) a pass, at most as many passes as asked for.
#pragma once

#include <cstdint>
#include <span>

#include "mesh/adaptation/ellipse_cavity.h"
#include "mesh/adaptation/metric_mesh.h"

namespace tetfarm {

/// In mean lengths.
struct MeanLengthRules {
  double shortest = 0.8;
  double longest = 1.2;
  int passes = 20;
  std::int64_t most_triangles = 100'000'000;
};

/// The mean metric length of the edges. @pre at least one triangle
double mean_edge_length(const TriangleComplex& complex, std::span<const Metric2> metrics);

/// Coarsens, divides, swaps and smooths until no edge is divided and none goes. Metrics are such
/// that the mean length is 1. Returns in how many passes.
int adapt_by_mean_length(MetricMesh& mesh, const MetricField& field, EllipseCavity& cavity,
                         const MeanLengthRules& rules);

}  // namespace tetfarm
