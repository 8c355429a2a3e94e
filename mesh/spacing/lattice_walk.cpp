#include <cmath>

#include "mesh/spacing/level_shift.h"
#include "mesh/spacing/spacing_octree.h"

namespace tetfarm {
namespace {

/// The least i in [0, octree_span + 1] whose coordinate is at least x (or greater than x, if
/// `above`).
std::int32_t first_from(const GridFrame& frame, std::size_t axis, double x, bool above) {
  std::int32_t low = 0;
  std::int32_t high = octree_span + 1;
  while (low < high) {
    const std::int32_t middle = low + (high - low) / 2;
    const double c = frame.coordinate(axis, middle);
    if (above ? c > x : c >= x) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

class LatticeWalk {
 public:
  LatticeWalk(const SpacingOctree& octree, const Box3& box) : octree_(octree) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int a = static_cast<int>(axis);
      first_[axis] = first_from(octree.frame, axis, box.low[a], false);
      last_[axis] = first_from(octree.frame, axis, box.high[a], true) - 1;
    }
  }

  std::vector<LatticeNode> run() {
    visit(0, {0, {}});
    return std::move(nodes_);
  }

 private:
  bool meets(const LatticeCell& cell) const {
    const std::int32_t size = size_at_level(cell.level);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (cell.low[axis] > last_[axis] || cell.low[axis] + size < first_[axis]) return false;
    }
    return true;
  }

  void visit(std::size_t node, const LatticeCell& cell) {
    if (!meets(cell)) return;
    const std::int32_t child = octree_.child_of[node];
    if (child < 0) {
      const auto leaf = static_cast<std::size_t>(~child);
      if (octree_.lattice_level[leaf] > cell.level) {
        visit_block(cell, cell, octree_.lattice_level[leaf]);
      } else {
        emit(cell, octree_.owned_corners[leaf]);
      }
      return;
    }
    const std::int32_t half = size_at_level(cell.level + 1);
    for (std::size_t k = 0; k < 8; ++k) {
      visit(static_cast<std::size_t>(child) + k, {cell.level + 1, corner_of(cell.low, half, k)});
    }
  }

  void visit_block(const LatticeCell& cell, const LatticeCell& block, int lattice_level) {
    if (!meets(cell)) return;
    if (cell.level == lattice_level) {
      emit(cell, owned_in_block(cell, block));
      return;
    }
    const std::int32_t half = size_at_level(cell.level + 1);
    for (std::size_t k = 0; k < 8; ++k) {
      visit_block({cell.level + 1, corner_of(cell.low, half, k)}, block, lattice_level);
    }
  }

  /// Strictly inside a block all cells are equal, so each node is owned as corner 0.
  unsigned owned_in_block(const LatticeCell& cell, const LatticeCell& block) const {
    const std::int32_t size = size_at_level(cell.level);
    const std::int32_t block_size = size_at_level(block.level);
    unsigned owned = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      const GridPoint node = corner_of(cell.low, size, k);
      bool inside = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int32_t i = node[axis] - block.low[axis];
        inside = inside && i > 0 && i < block_size;
      }
      const bool owns = inside ? k == 0 : owner_of(octree_, node).low == cell.low;
      if (owns) owned |= 1U << k;
    }
    return owned;
  }

  void emit(const LatticeCell& cell, unsigned owned) {
    const std::int32_t size = size_at_level(cell.level);
    const double edge = size * octree_.frame.unit;
    const auto bits = static_cast<std::uint8_t>(octree_max_level + 1 - cell.level);
    for (std::size_t k = 0; k < 8; ++k) {
      const GridPoint corner = corner_of(cell.low, size, k);
      if ((owned >> k & 1U) == 0 || !is_in_box(corner)) continue;
      nodes_.push_back({octree_.frame.position(corner), edge, corner, bits,
                        shift_to_coarser(octree_, corner, cell.level)});
    }
    const GridPoint centre = corner_of(cell.low, size / 2, 7);
    if (is_in_box(centre))
      nodes_.push_back({octree_.frame.position(centre), edge, centre, bits, {}});
  }

  bool is_in_box(const GridPoint& p) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (p[axis] < first_[axis] || p[axis] > last_[axis]) return false;
    }
    return true;
  }

  const SpacingOctree& octree_;
  GridPoint first_{};
  GridPoint last_{};
  std::vector<LatticeNode> nodes_;
};

}  // namespace

std::vector<LatticeNode> lattice_nodes_in(const SpacingOctree& octree, const Box3& box) {
  return LatticeWalk(octree, box).run();
}

}  // namespace tetfarm
