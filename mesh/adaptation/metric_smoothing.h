/// Moves nodes to where the triangles round them are nearer to equilateral ones of unit edges.
///
/// Source: the optimal points of P. Frey and P.-L. George, "Mesh Generation" (2000), 17.3, with the
/// energy of triangle_energy() as judge: a step that does not lower its sum over the ball is
/// halved, and in the end not made. Nodes of a curve move along it. Cost: O(nodes).
#pragma once

#include "mesh/adaptation/metric_mesh.h"

namespace tetfarm {

/// The active nodes, once each; one that finds nothing to gain is no longer active, and the
/// neighbours of one that moves are. Returns how many moved.
std::int64_t smooth_nodes(MetricMesh& mesh, const MetricField& field);

}  // namespace tetfarm
