/// The nodes of the lattice counted by volume: cell by cell of the octree, never node by node.
///
/// Source: none in the thesis, which has no lattice. A spacing of a millionth of the domain gives
/// blocks of 2^60 cells; walking along their faces alone takes days. What such a job would come to
/// has to be said at once (mesh/decompose/work_estimate.h). Units: as spacing_octree.h.
#pragma once

#include <cstddef>

#include "mesh/spacing/spacing_octree.h"

namespace tetfarm {

/// What a walk over the lattice may visit; beyond, its nodes are counted by volume. A cube with
/// 1,670 cells along each edge has so many at its faces, and some 50 thousand million elements.
inline constexpr double most_cells_walked = 1 << 24;

/// How many cells a walk over the lattice nodes of the box visits one by one, at most: those of the
/// octree, and of its blocks those that lie at a face of the block or of the box.
/// Cost: O(octree cells that meet the box), a few nanoseconds each.
double cells_to_walk(const SpacingOctree& octree, const Box3& box);

/// Points of the box, `most` of them, as dense as the lattice nodes are, each with the edge of the
/// lattice's cells there; `nodes_for_each` is the number of nodes by volume over `most`. They are
/// no nodes of the lattice: `grid` and `cell_bits` are not set.
/// @pre most > 0. Cost: O(octree cells that meet the box + most), whatever the number of nodes.
LatticeSample sample_by_volume(const SpacingOctree& octree, const Box3& box, std::size_t most);

}  // namespace tetfarm
