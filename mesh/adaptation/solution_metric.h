/// The metric of a solution: of each field its own, intersected.
///
/// Source: thesis 3.3.1, equations 11 to 14; Loseille and Alauzet for the Lp norm
/// (metric_scaling.h). Several fields are made to the same complexity, and intersected in their
/// order. Cost: O(n) a field.
#pragma once

#include <span>
#include <vector>

#include "mesh/adaptation/metric_scaling.h"

namespace tetfarm {

struct SolutionMetricOptions {
  bool is_lp = true;  ///< otherwise the thesis's recipe: absolute second derivatives
  double norm = 2;    ///< of Lp
};

/// At each node. `complex`: checked_complex() of the mesh. @pre at least one field; each has a
/// finite value for each node.
std::vector<Metric2> metrics_of_solution(const TriangleComplex& complex,
                                         std::span<const std::vector<double>> fields,
                                         const SolutionMetricOptions& options);

}  // namespace tetfarm
