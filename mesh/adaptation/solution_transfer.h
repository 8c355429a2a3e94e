/// Brings the fields of a solution from the mesh on which they were computed to another mesh of the
/// same domain.
///
/// Source: thesis 3.3.3, end. Numbers are interpolated (solution_interpolation.h) or carried over
/// with their integrals (conservative_transfer.h); metrics are interpolated by their logarithms
/// (mesh/metric/metric2.h) either way, as they have no integral to keep.
/// Cost: O(n log n), some microseconds a node.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/metric/metric2.h"
#include "mesh/planar/plane_mesh.h"

namespace tetfarm {

enum class TransferMethod { linear, conservative };

/// Of a field, over the nodes that triangles use.
struct FieldFigures {
  double min = 0;
  double max = 0;
  double integral = 0;
};

struct TransferredField {
  std::vector<double> values;
  FieldFigures before;
  FieldFigures after;
  /// What the integral has gained, as a share of that of the absolute values before.
  double gain = 0;
};

struct TransferredSolution {
  std::vector<TransferredField> fields;
  std::vector<std::vector<Metric2>> metrics;
  std::int64_t nodes_outside = 0;  ///< of the old mesh, by more than rounding
  double farthest_outside = 0;
  Vec2 farthest_at;             ///< the node of that distance
  double covered_percent = -1;  ///< of the new domain by the old one; only where conservative
};

/// Fields and metrics: a value at each point of the old mesh. @pre check_values, check_metrics.
/// @throws InvalidInput when a mesh is wrong, when the two do not overlap, or as MeshIntersection.
TransferredSolution transfer_solution(const PlaneMesh& from,
                                      std::span<const std::vector<double>> fields,
                                      std::span<const std::vector<Metric2>> metrics,
                                      const PlaneMesh& to, TransferMethod method);

}  // namespace tetfarm
