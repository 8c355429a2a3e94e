/// Whether edges of the boundary cross each other: the two walls of a narrow gap can, though every
/// triangle is valid. Coarsening takes care (border_nodes.h); nodes that move along their curves
/// do not.
///
/// Exact. Cost: O(n log n), and the pairs of edges whose boxes meet.
#pragma once

#include <optional>

#include "mesh/planar/plane_mesh.h"

namespace tetfarm {

/// The middle of an edge that meets another one with no node in common, if there is one.
std::optional<Vec2> find_border_crossing(const PlaneMesh& mesh);

}  // namespace tetfarm
