#include "mesh/spacing/even_blocks.h"

#include <optional>

#include "base/check.h"

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

/// The cell and what touches it; nothing when that reaches beyond the octree.
std::optional<GridBox> box_round(const LatticeCell& cell) {
  const std::int32_t size = size_at_level(cell.level);
  GridBox box{cell.low, cell.low};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] -= 1;
    box.high[axis] += size;
    if (box.low[axis] < 0 || box.high[axis] >= octree_span) return {};
  }
  return box;
}

/// Whether all of the octree's node that lies in the box has a lattice of that level.
bool has_one_level(const SpacingOctree& octree, std::size_t node, const LatticeCell& cell,
                   const GridBox& box, int lattice_level) {
  const std::int32_t size = size_at_level(cell.level);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (cell.low[axis] > box.high[axis] || cell.low[axis] + size <= box.low[axis]) return true;
  }
  const std::int32_t child = octree.child_of[node];
  if (child < 0) return octree.lattice_level[static_cast<std::size_t>(~child)] == lattice_level;
  const std::int32_t half = size_at_level(cell.level + 1);
  for (std::size_t k = 0; k < 8; ++k) {
    const LatticeCell part{cell.level + 1, corner_of(cell.low, half, k)};
    if (!has_one_level(octree, static_cast<std::size_t>(child) + k, part, box, lattice_level)) {
      return false;
    }
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
    const std::optional<GridBox> box = box_round(block);
    if (!box) return false;
    auto whole = around_.rbegin();
    while (!holds(whole->cell, *box)) {
      ++whole;
      TF_CHECK(whole != around_.rend());  // the octree's root holds every box inside
    }
    return has_one_level(octree_, whole->node, whole->cell, *box, lattice_level);
  }

  struct OctreeNode {
    std::size_t node = 0;
    LatticeCell cell;
  };

  SpacingOctree& octree_;
  std::vector<OctreeNode> around_;  // the node that is visited, from the octree's root on
};

}  // namespace

bool is_among_equals(const SpacingOctree& octree, const LatticeCell& cell, int lattice_level) {
  const std::optional<GridBox> box = box_round(cell);
  return box && has_one_level(octree, 0, {0, {}}, *box, lattice_level);
}

void mark_even_blocks(SpacingOctree& octree) { EvenBlocks(octree).visit(0, {0, {}}); }

}  // namespace tetfarm
