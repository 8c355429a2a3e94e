#include "mesh/spacing/even_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/spacing/octree_build.h"

namespace tetfarm {
namespace {

/// A small source in a background that is kept in blocks.
SpacingOctree blocks_round_a_source() {
  const double background = 0.02;
  SpacingDemand demand{DemandTree({}, 0.5), {}, background, 0.5, background};
  demand.sources.push_back(source_demand({{{{0.21, 0.33, 0.4}, 0.004, 0.01, 0.02}}}, 0.5));
  Box3 domain;
  domain.add(Vec3{0, 0, 0});
  domain.add(Vec3{1, 1, 1});
  return build_octree(demand, grid_frame(domain, background), domain);
}

/// Whether the cells of a block's lattice and those round it are of one level; false at the rim.
bool has_equals_round(const SpacingOctree& octree, const LatticeCell& block, int level) {
  const std::int32_t step = size_at_level(level);
  const std::int32_t size = size_at_level(block.level);
  for (std::int32_t x = -step; x <= size; x += step) {
    for (std::int32_t y = -step; y <= size; y += step) {
      for (std::int32_t z = -step; z <= size; z += step) {
        const GridPoint p{block.low[0] + x, block.low[1] + y, block.low[2] + z};
        if (std::ranges::any_of(p, [](auto i) { return i < 0 || i >= octree_span; })) return false;
        // Of a cell that is smaller the low corner, of a larger one any corner will do.
        if (lattice_cell_at(octree, p).level != level) return false;
      }
    }
  }
  return true;
}

struct Counts {
  int even = 0;
  int uneven = 0;
  int even_parts_of_uneven = 0;
};

/// The eighths of a block.
void check_parts(const SpacingOctree& octree, const LatticeCell& block, int lattice_level,
                 Counts& counts) {
  for (std::size_t k = 0; k < 8; ++k) {
    const LatticeCell part{block.level + 1,
                           corner_of(block.low, size_at_level(block.level + 1), k)};
    const bool is_even = has_equals_round(octree, part, lattice_level);
    EXPECT_EQ(is_among_equals(octree, part, lattice_level), is_even);
    if (is_even) ++counts.even_parts_of_uneven;
  }
}

void check_blocks(const SpacingOctree& octree, std::size_t node, const LatticeCell& cell,
                  Counts& counts) {
  const std::int32_t child = octree.child_of[node];
  if (child >= 0) {
    for (std::size_t k = 0; k < 8; ++k) {
      const GridPoint low = corner_of(cell.low, size_at_level(cell.level + 1), k);
      check_blocks(octree, static_cast<std::size_t>(child) + k, {cell.level + 1, low}, counts);
    }
    return;
  }
  const auto leaf = static_cast<std::size_t>(~child);
  const int lattice_level = octree.lattice_level[leaf];
  if (lattice_level == cell.level) return;
  const bool is_even = has_equals_round(octree, cell, lattice_level);
  EXPECT_EQ(is_among_equals(octree, cell, lattice_level), is_even);
  EXPECT_EQ(octree.owned_corners[leaf], is_even ? owned_among_equals : 0);
  ++(is_even ? counts.even : counts.uneven);
  if (!is_even) check_parts(octree, cell, lattice_level, counts);
}

TEST(EvenBlocks, are_marked_where_all_round_them_is_of_their_size) {
  const SpacingOctree octree = blocks_round_a_source();
  Counts counts;
  check_blocks(octree, 0, {0, {}}, counts);
  EXPECT_GT(counts.even, 10);
  EXPECT_GT(counts.uneven, 10);
  EXPECT_GT(counts.even_parts_of_uneven, 10);
}

void forget_marks(SpacingOctree& octree, std::size_t node, int level) {
  const std::int32_t child = octree.child_of[node];
  if (child < 0) {
    const auto leaf = static_cast<std::size_t>(~child);
    if (octree.lattice_level[leaf] > level) octree.owned_corners[leaf] = 0;
    return;
  }
  for (std::size_t k = 0; k < 8; ++k) {
    forget_marks(octree, static_cast<std::size_t>(child) + k, level + 1);
  }
}

TEST(EvenBlocks, have_the_same_lattice_without_the_mark) {
  SpacingOctree octree = blocks_round_a_source();
  Box3 box;
  box.add(Vec3{0.1, 0.2, 0.3});
  box.add(Vec3{0.9, 0.5, 0.7});
  const LatticeSample marked = sample_lattice_in(octree, box, 1000);
  forget_marks(octree, 0, 0);
  const LatticeSample looked_up = sample_lattice_in(octree, box, 1000);
  ASSERT_EQ(looked_up.nodes.size(), marked.nodes.size());
  EXPECT_EQ(looked_up.nodes_for_each, marked.nodes_for_each);
  for (std::size_t i = 0; i < marked.nodes.size(); ++i) {
    EXPECT_EQ(looked_up.nodes[i].grid, marked.nodes[i].grid);
    EXPECT_EQ(looked_up.nodes[i].shift, marked.nodes[i].shift);
    EXPECT_EQ(looked_up.nodes[i].cell_bits, marked.nodes[i].cell_bits);
  }
}

}  // namespace
}  // namespace tetfarm
