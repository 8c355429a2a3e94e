/// Makes vertices and edges of triangles that meet one where they nearly are.
///
/// Source: S. Lazard and L. Valque, "Removing self-intersections in 3D meshes while preserving
/// floating-point coordinates" (2025): what is nearly on a vertex, an edge or a face becomes one
/// with it, so that faces that nearly lie on each other do not cross again and again in their last
/// bits. Lengths in the unit of the input.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/arrangement/chain_triangle.h"

namespace tetfarm {

/// Vertices of two triangles that meet, within `distance` of each other, become the first of them.
/// How many pairs there were. Deterministic. Cost: O(n + pairs).
std::int64_t join_near_vertices(TriangleChain& chain, const std::vector<TrianglePair>& pairs,
                                double distance);

/// For every two triangles that meet: an edge is divided at a vertex of the other within
/// `distance`, and two edges where they come so near; where there are none of these, a triangle is
/// divided at a vertex near it. The border of the chain stays the same but for what is divided of
/// it. The number of changes; what one change is in the way of comes with the next call. @pre
/// vertices of theirs are farther apart than that. Deterministic. Cost: O(n log n + pairs).
std::int64_t snap_to_neighbours(TriangleChain& chain, const std::vector<TrianglePair>& pairs,
                                double distance);

}  // namespace tetfarm
