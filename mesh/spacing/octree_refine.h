/// The shape of the spacing octree: split to the demand, then balanced 2:1.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/spacing/spacing_demand.h"
#include "mesh/spacing/spacing_octree.h"

namespace tetfarm {

/// Node 0 is the root; child_of 0 marks a leaf, else the first of 8 consecutive children.
struct RefinedTree {
  std::vector<std::int32_t> child_of{0};
  std::vector<std::uint8_t> lattice_level{0};
};

/// The cell as a CellDemand wants it.
CellDemand::Cell demand_cell(const GridFrame& frame, const LatticeCell& cell);

/// Some minutes of work. A cell of the wanted size looks at some dozens of demands; only sources by
/// the thousand at one place come to this many.
inline constexpr std::uint64_t most_looks = std::uint64_t{1} << 35U;

/// Splits to the rule of octree_build.h. Where no background is set, cells farther outside the
/// domain than their own edge stay as they are.
/// @throws InvalidInput when there would be more than most_leaves leaves, or when that would take
/// more than so many looks at demands (CellDemand::looked_at).
RefinedTree refine(const SpacingDemand& demand, const GridFrame& frame, const Box3& domain,
                   std::uint64_t looks = most_looks);

/// Splits until lattice cells that touch, be it in a corner, differ by at most one level.
/// @throws InvalidInput as refine. Cost: O(nodes * depth).
void balance(RefinedTree& tree);

}  // namespace tetfarm
