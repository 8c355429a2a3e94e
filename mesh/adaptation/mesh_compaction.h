/// Numbers the nodes and triangles of a mesh anew along a space-filling curve, without those that
/// have gone: what lies side by side is side by side in memory, and operations that go over the
/// mesh in the order of its numbers find it there.
///
/// Source: Hilbert curve (mesh/geometry/hilbert_order.h). Determinism: the numbers follow from the
/// places of the nodes, those of the triangles from their lowest nodes. Cost: O(nodes).
#pragma once

#include "mesh/adaptation/metric_mesh.h"

namespace tetfarm {

/// The same mesh with other numbers; triangles begin with the node that they began with.
void compact(MetricMesh& mesh);

}  // namespace tetfarm
