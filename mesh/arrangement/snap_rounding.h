/// Divides edges of one plane where they cross, and leads them through the points that they nearly
/// pass.
///
/// Source: D. Halperin and E. Packer, "Iterated snap rounding" (2002): no point is left nearer to
/// an edge than a distance unless it is on it, so that the edges can be rounded without crossing
/// anew.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/core/vec3.h"

namespace tetfarm {

/// Numbers of two points.
using SnapEdge = std::array<std::int32_t, 2>;

/// For each edge the points that it now runs through, from its first to its second; pieces of
/// different edges cross nowhere, as seen along the axis. Points where edges cross are added, in
/// the middle between the two. Nothing where there is no end after 100 passes.
/// @pre `edges` join different points; those that no edge has are of no account. Deterministic.
/// Cost: O(n log n + pairs whose boxes overlap) a pass, a few passes.
std::optional<std::vector<std::vector<std::int32_t>>> snap_round(std::vector<Vec3>& points,
                                                                 const std::vector<SnapEdge>& edges,
                                                                 int axis, double distance);

}  // namespace tetfarm
