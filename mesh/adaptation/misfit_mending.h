/// Last of all, the few edges and triangles that still do not fit: their nodes are moved, each to
/// the best of the places round it, until their worst edges and shapes are within the limits.
///
/// Source: none; pattern search (R. Hooke, T. A. Jeeves, 1961) in the ellipse of the node, on what
/// the worst elements weigh most in. A share of edges that fit hides a few enormous ones, and these
/// carry the error of a solution. Cost: O(triangles) and some 40 tries for each node of a misfit.
#pragma once

#include "mesh/adaptation/metric_mesh.h"

namespace tetfarm {

struct FittingLimits {
  double shortest = 0.69;
  double longest = 1.31;
  double worst_energy = 6.2;  ///< of triangle_energy()
};

/// Marks the nodes of edges and triangles outside the limits as active, and no others that were
/// not. Returns how many triangles there are.
std::int64_t activate_misfits(MetricMesh& mesh, const FittingLimits& limits);

/// Moves the nodes of misfits, in the order of their numbers. Returns how many moved.
std::int64_t mend_misfits(MetricMesh& mesh, const MetricField& field, const FittingLimits& limits);

}  // namespace tetfarm
