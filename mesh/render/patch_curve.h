/// A field along the boundary: its values at the nodes of some patches, in the order in which the
/// edges of the patches lead from one to the next.
///
/// Cost: O(n log n) in the edges of the patches.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/planar/plane_mesh.h"

namespace tetfarm {

/// Nodes along connected edges of the patches. A line that closes ends with the node it began
/// with; where other than two edges meet lines end. Lines begin at the lowest such node, and those
/// that close at their lowest. @pre edges name nodes of the mesh.
std::vector<std::vector<std::int32_t>> patch_lines(const PlaneMesh& mesh,
                                                   std::span<const std::int32_t> patches);

/// Lines of points with the x of the nodes and the values there. @pre a value for each node
std::vector<std::vector<Vec2>> values_over_x(const PlaneMesh& mesh, std::span<const double> values,
                                             std::span<const std::int32_t> patches);

}  // namespace tetfarm
