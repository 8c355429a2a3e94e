/// Takes nodes away whose edges are too short.
///
/// Source: thesis 3.3.3.2 and 3.3.3.4. Departs: one of the two ends goes and the other stays where
/// it is, so that nodes of the boundary never leave their curve; and only where no new edge is too
/// long, so that refinement does not bring back what has gone. Cost: O(edges).
#pragma once

#include "mesh/adaptation/border_nodes.h"
#include "mesh/adaptation/metric_mesh.h"

namespace tetfarm {

struct CollapseLimits {
  double shortest = 0.70710678;  ///< shorter edges go
  double longest = 1.41421356;   ///< no new edge is longer
  /// No new triangle is worse than this, unless the worst that goes is worse still.
  double worst_energy = 12;
};

/// Goes over the edges once. Returns how many nodes went.
std::int64_t collapse_edges(MetricMesh& mesh, const CollapseLimits& limits, EdgesToVisit which);

/// Joins `node` to `target` along their edge, if that is allowed. False with nothing changed.
/// `border`: of the mesh, where a node of a border may go: it stays where the new edge would meet
/// another wall.
bool collapse_node(MetricMesh& mesh, std::int32_t node, std::int32_t target,
                   const CollapseLimits& limits, Ball& ball, LazyBorder* border = nullptr);

}  // namespace tetfarm
