/// Where lattice cells of two sizes meet, the corners between them are better a little way towards
/// the larger cells: the step from one size to the next is then spread over two layers of tets.
///
/// Source: none in the thesis, which has no lattice. Measured:
/// docs/decisions/0004-spacing-octree.md.
#pragma once

#include <array>
#include <cstdint>

#include "mesh/spacing/spacing_octree.h"

namespace tetfarm {

/// The shift of a corner whose smallest cell has the level, for LatticeNode::shift; zero when no
/// larger cell touches it. Cost: eight look-ups in the octree.
std::array<std::int8_t, 3> shift_to_coarser(const SpacingOctree& octree, const GridPoint& corner,
                                            int level);

}  // namespace tetfarm
