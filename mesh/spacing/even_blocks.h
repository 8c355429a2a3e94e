/// Which blocks of the spacing octree lie among cells of their own lattice's size.
///
/// Source: none in the thesis, which has no lattice. Found out once, when the octree is built: each
/// walk over the lattice asks it of every block it meets.
#pragma once

#include "mesh/spacing/spacing_octree.h"

namespace tetfarm {

/// The mask of corners that each cell of such a block owns.
inline constexpr std::uint8_t owned_among_equals = 1;

/// Whether the lattice has cells of that level only in the cell and in all that touches it, which
/// the octree's border does not. Cost: O(depth) where that is so, and O(leaves that touch it).
bool is_among_equals(const SpacingOctree& octree, const LatticeCell& cell, int lattice_level);

/// Gives each block whose cells, with all that touch it, have one size the mask
/// owned_among_equals, and 0 to the others.
/// Cost: O(leaves that touch blocks * depth).
void mark_even_blocks(SpacingOctree& octree);

}  // namespace tetfarm
