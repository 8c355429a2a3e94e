#include "mesh/filling/lattice_grid.h"

#include <gtest/gtest.h>

#include "base/array_index.h"
#include "tests/mesh/filling/lattice_cases.h"

namespace tetfarm {
namespace {

using Grid3 = std::array<std::int32_t, 3>;

Grid3 moved(const Grid3& p, std::int32_t size, int x, int y, int z) {
  return {p[0] + size * x, p[1] + size * y, p[2] + size * z};
}

TEST(LatticeGrid, holds_each_node_once) {
  for (const SpacingField& field : {lattice_cases::uniform(), lattice_cases::graded()}) {
    const auto nodes = field.lattice_nodes(lattice_cases::box());
    const LatticeGrid grid(nodes);
    std::vector<int> seen(nodes.size(), 0);
    for (std::int32_t slot = 0; slot < grid.slot_count(); ++slot) {
      if (grid.centre(slot) >= 0) ++seen[at(grid.centre(slot))];
      if (grid.low_corner(slot) >= 0) ++seen[at(grid.low_corner(slot))];
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(nodes.size()));
  }
}

TEST(LatticeGrid, steps_to_the_cells_of_the_same_size) {
  for (const SpacingField& field : {lattice_cases::uniform(), lattice_cases::graded()}) {
    const auto nodes = field.lattice_nodes(lattice_cases::box());
    const LatticeGrid grid(nodes);
    std::int64_t steps = 0;
    for (std::int32_t slot = 0; slot < grid.slot_count(); ++slot) {
      if (grid.centre(slot) < 0) continue;
      const LatticeNode& centre = nodes[at(grid.centre(slot))];
      for (int n = 0; n < 27; ++n) {
        const int x = n % 3 - 1, y = n / 3 % 3 - 1, z = n / 9 - 1;
        const std::int32_t beside = grid.neighbour(slot, x, y, z);
        if (beside == LatticeGrid::none || grid.centre(beside) < 0) continue;
        const LatticeNode& other = nodes[at(grid.centre(beside))];
        EXPECT_EQ(other.grid, moved(centre.grid, centre.cell_size(), x, y, z));
        EXPECT_EQ(other.cell_size(), centre.cell_size());
        ++steps;
      }
    }
    EXPECT_GT(steps, static_cast<std::int64_t>(5 * nodes.size()));
  }
}

TEST(LatticeGrid, knows_the_corners_of_a_cell) {
  const auto nodes = lattice_cases::graded().lattice_nodes(lattice_cases::box());
  const LatticeGrid grid(nodes);
  std::int64_t corners = 0;
  for (std::int32_t slot = 0; slot < grid.slot_count(); ++slot) {
    if (grid.centre(slot) < 0) continue;
    const LatticeNode& centre = nodes[at(grid.centre(slot))];
    for (std::size_t k = 0; k < 8; ++k) {
      const std::int32_t corner = grid.corner(slot, k);
      if (corner < 0) continue;
      const std::int32_t half = centre.cell_size() / 2;
      const auto side = [k](unsigned axis) { return (k >> axis & 1U) != 0 ? 1 : -1; };
      EXPECT_EQ(nodes[at(corner)].grid, moved(centre.grid, half, side(0), side(1), side(2)));
      ++corners;
    }
  }
  EXPECT_GT(corners, static_cast<std::int64_t>(nodes.size()));
}

TEST(LatticeGrid, calls_blocks_deep_that_have_every_centre_near) {
  const auto nodes = lattice_cases::fine().lattice_nodes(lattice_cases::box());
  const LatticeGrid grid(nodes);
  int deep = 0;
  for (std::int32_t slot = 0; slot < grid.slot_count(); ++slot) {
    if (!grid.is_deep(slot / LatticeGrid::slots_in_block)) continue;
    ++deep;
    for (int n = 0; n < 27; ++n) {
      const std::int32_t beside = grid.neighbour(slot, n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      ASSERT_NE(beside, LatticeGrid::none);
      ASSERT_NE(grid.centre(beside), LatticeGrid::none);
    }
  }
  EXPECT_GT(deep, 0);
  EXPECT_LT(deep, grid.slot_count());
}

TEST(LatticeGrid, calls_no_block_deep_that_has_no_block_beside_it) {
  // The centres of all cells of size 2 in blocks of 4 x 4 x 4: one block, then 3 x 3 x 3.
  for (const std::int32_t blocks : {1, 3}) {
    std::vector<LatticeNode> nodes;
    for (std::int32_t x = 0; x < 4 * blocks; ++x) {
      for (std::int32_t y = 0; y < 4 * blocks; ++y) {
        for (std::int32_t z = 0; z < 4 * blocks; ++z) {
          LatticeNode node;
          node.cell_bits = 1;
          node.grid = {8 + 2 * x + 1, 8 + 2 * y + 1, 8 + 2 * z + 1};
          nodes.push_back(node);
        }
      }
    }
    const LatticeGrid grid(nodes);
    int deep = 0;
    for (std::int32_t block = 0; block < blocks * blocks * blocks; ++block) {
      deep += grid.is_deep(block) ? 1 : 0;
    }
    EXPECT_EQ(deep, blocks == 1 ? 0 : 1);
  }
}

TEST(LatticeGrid, of_no_nodes_has_no_slots) {
  EXPECT_EQ(LatticeGrid(std::span<const LatticeNode>{}).slot_count(), 0);
}

}  // namespace
}  // namespace tetfarm
