/// Makes one layer of triangles that nearly lie on each other.
///
/// Source: faces that were meant to be one, as those of parts that stand flush, cross each other
/// again and again in their last bits. They are put into one plane with all their edges
/// (snap_rounding.h), which is triangulated once for all. Lengths in the unit of the input.
#pragma once

#include <vector>

#include "mesh/arrangement/chain_triangle.h"

namespace tetfarm {

/// Of the pairs that meet, those of which the corners of one lie within a few times `distance` of
/// the plane of the other, and all that are so joined, become one layer; vertices of it that are
/// seen within the distance of each other are made one first. Edges that are divided are so in all
/// their triangles. A layer that cannot be made stays. Whether any was made. Deterministic. Cost:
/// O(n log n), and for each layer that of snap_round.
bool merge_layers(TriangleChain& chain, const std::vector<TrianglePair>& pairs, double distance);

}  // namespace tetfarm
