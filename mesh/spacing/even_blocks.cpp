#include "mesh/spacing/even_blocks.h"

namespace tetfarm {
namespace {

struct GridBox {
  GridPoint low{};
  GridPoint high{};
};

bool holds(const LatticeCell& cell, const GridBox& box) {
  const std::int32_t size = size_at_level(cell.level);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (box.low[axis] < cell.low[axis] || box.high[axis] >= cell.low[axis] + size) return false;
  }
  return true;
}

class EvenBlocks {
 public:
  explicit EvenBlocks(SpacingOctree& octree) : octree_(octree) {}

  void visit(std::size_t node, const LatticeCell& cell) {
    const std::int32_t child = octree_.child_of[node];
    if (child < 0) {
      const auto leaf = static_cast<std::size_t>(~child);
      const int lattice_level = octree_.lattice_level[leaf];
      if (lattice_level == cell.level) return;
      octree_.owned_corners[leaf] = is_among_equals(cell, lattice_level) ? owned_among_equals : 0;
      return;
    }
    const std::int32_t half = size_at_level(cell.level + 1);
    around_.push_back({node, cell});
    for (std::size_t k = 0; k < 8; ++k) {
      visit(static_cast<std::size_t>(child) + k, {cell.level + 1, corner_of(cell.low, half, k)});
    }
    around_.pop_back();
  }

 private:
  /// Whether all that touches the block, and the block itself, has cells of that level: asked of
  /// the smallest node round it that holds all that.
  bool is_among_equals(const LatticeCell& block, int lattice_level) const {
    const std::int32_t size = size_at_level(block.level);
    GridBox box{block.low, block.low};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] -= 1;
      box.high[axis] += size;
      if (box.low[axis] < 0 || box.high[axis] >= octree_span) return false;
    }
    auto whole = around_.rbegin();
    while (!holds(whole->cell, box)) ++whole;
    return has_one_level(whole->node, whole->cell, box, lattice_level);
  }

  bool has_one_level(std::size_t node, const LatticeCell& cell, const GridBox& box,
                     int lattice_level) const {
    const std::int32_t size = size_at_level(cell.level);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (cell.low[axis] > box.high[axis] || cell.low[axis] + size <= box.low[axis]) return true;
    }
    const std::int32_t child = octree_.child_of[node];
    if (child < 0) return octree_.lattice_level[static_cast<std::size_t>(~child)] == lattice_level;
    const std::int32_t half = size_at_level(cell.level + 1);
    for (std::size_t k = 0; k < 8; ++k) {
      const LatticeCell part{cell.level + 1, corner_of(cell.low, half, k)};
      if (!has_one_level(static_cast<std::size_t>(child) + k, part, box, lattice_level)) {
        return false;
      }
    }
    return true;
  }

  struct OctreeNode {
    std::size_t node = 0;
    LatticeCell cell;
  };

  SpacingOctree& octree_;
  std::vector<OctreeNode> around_;  // the node that is visited, from the octree's root on
};

}  // namespace

void mark_even_blocks(SpacingOctree& octree) { EvenBlocks(octree).visit(0, {0, {}}); }

}  // namespace tetfarm
