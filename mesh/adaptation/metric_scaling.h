/// From what is wished to what can be meshed: the density that gives a number of nodes, within
/// limits of size and aspect and with gradual changes of size, all at once.
///
/// Source: A. Loseille and F. Alauzet, "Continuous mesh framework" I (2011) for the Lp metric and
/// its complexity; F. Alauzet, "Size gradation control of anisotropic meshes" (2010). Thesis 3.3.1,
/// equation 14, clips the sizes alone. Limits and gradation lie inside the search for the scale:
/// applied behind it they change the number of nodes a hundredfold.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mesh/adaptation/metric_sources.h"
#include "mesh/metric/metric2.h"
#include "mesh/planar/triangle_complex.h"

namespace tetfarm {

struct MetricLimits {
  double h_min = 0;      ///< 0: none
  double h_max = 0;      ///< 0: none
  double aspect = 1e4;   ///< largest size over smallest, at a point
  double gradation = 0;  ///< sizes grow by at most this from edge to edge; 0: off
};

/// Of one metric, sizes and aspect within the limits; too large an aspect makes the larger size
/// smaller.
Metric2 limited(const Metric2& metric, const MetricLimits& limits);

/// Metrics no denser than those of neighbours allow: each grown along the edges by the gradation
/// and intersected into that of the other end, until nothing changes. Reads one state and writes
/// the next, so that no order counts. Cost: O(nodes) for each ring that a change spreads.
std::vector<Metric2> graded(const TriangleComplex& complex, std::vector<Metric2> metrics,
                            double gradation);

/// |H| det(|H|)^(-1/(2p+2)) of a field: the metric whose meshes have the least error in the Lp norm
/// for their number of nodes, but for its scale. Eigenvalues below 1e-12 of the field's largest, or
/// 1e-8 of the node's own, are raised to that: where a field is flat it asks for nothing. A higher
/// share, as absolute() has it, spends most nodes far away where the domain is large.
std::vector<Metric2> lp_metrics(std::span<const Metric2> hessians, double norm);
/// Absolute eigenvalues as they are (thesis, equation 14), but at least 1e-6 of the field's
/// largest.
std::vector<Metric2> absolute(std::span<const Metric2> hessians);

/// Nodes of a mesh of unit edges for each unit of complexity; more where much of it is boundary.
inline constexpr double nodes_per_complexity = 1.18;

/// The integral of the square root of the determinant over the triangles.
double complexity(const TriangleComplex& complex, std::span<const Metric2> metrics);

struct ScaledMetric {
  std::vector<Metric2> metrics;
  double scale = 1;  ///< of lengths: metrics are those wished for times its square, then limited
  double complexity = 0;
  // Nodes at which each limit changed something.
  std::int64_t at_h_min = 0;
  std::int64_t at_h_max = 0;
  std::int64_t at_aspect = 0;
  std::int64_t by_gradation = 0;
  std::vector<std::uint8_t> sources_act = {};  ///< sourced_complexity.h
};

/// The wish as it is, limited and graded. `sources`, where there are some, count in the complexity
/// alone: neither limits nor scale are theirs.
ScaledMetric limited_metric(const TriangleComplex& complex, std::vector<Metric2> wish,
                            const MetricLimits& limits, const MetricSources* sources = nullptr);
/// Scaled so that its complexity, limited and graded, is `wanted` within 1 %.
/// @throws InvalidInput when limits or sources do not let it: says how many they allow.
ScaledMetric scaled_to(const TriangleComplex& complex, std::span<const Metric2> wish,
                       const MetricLimits& limits, double wanted,
                       const MetricSources* sources = nullptr);

}  // namespace tetfarm
