#include <bit>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "mesh/spacing/even_blocks.h"
#include "mesh/spacing/level_shift.h"
#include "mesh/spacing/spacing_octree.h"
#include "mesh/spacing/systematic_sample.h"

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
  LatticeWalk(const SpacingOctree& octree, const Box3& box, const LatticeFilter& filter)
      : octree_(octree),
        plane_(filter.plane),
        is_needless_(filter.is_needless),
        visits_(filter.visits) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int a = static_cast<int>(axis);
      first_[axis] = first_from(octree.frame, axis, box.low[a], false);
      last_[axis] = first_from(octree.frame, axis, box.high[a], true) - 1;
    }
  }

  std::vector<LatticeNode> all() {
    walk(Purpose::all);
    return std::move(nodes_);
  }

  /// Counts the nodes, then collects those that are chosen: both walks pass over most of what they
  /// meet, which one that collects and drops again does not.
  LatticeSample sample(std::size_t most) {
    walk(Purpose::count);
    const std::size_t nodes = seen_;
    choice_ = systematic_sample(nodes, most);
    walk(Purpose::choice);
    // Both walks saw the same.
    TF_CHECK(seen_ == nodes && next_found_ == found_.size());
    TF_CHECK(nodes_.size() == choice_.numbers.size());
    return {std::move(nodes_), static_cast<double>(choice_.stride)};
  }

 private:
  enum class Purpose { all, count, choice };

  void walk(Purpose purpose) {
    purpose_ = purpose;
    seen_ = 0;
    visit(0, {0, {}});
  }

  bool meets(const LatticeCell& cell) const {
    if (visits_ != nullptr) ++visits_->cells;
    const std::int32_t size = size_at_level(cell.level);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (cell.low[axis] > last_[axis] || cell.low[axis] + size < first_[axis]) return false;
    }
    return plane_ == nullptr || meets_plane(cell.low, size);
  }

  bool meets_plane(const GridPoint& low, std::int32_t size) const {
    const std::int32_t at_low = low[plane_->axis] + plane_->sign * low[plane_->other_axis];
    const std::int32_t least = plane_->sign > 0 ? at_low : at_low - size;
    const std::int32_t largest = plane_->sign > 0 ? at_low + 2 * size : at_low + size;
    return least <= plane_->sum && plane_->sum <= largest;
  }

  bool is_left_out(const LatticeCell& cell) const {
    if (is_needless_ == nullptr) return false;
    if (visits_ != nullptr) ++visits_->questions;
    const std::int32_t size = size_at_level(cell.level);
    Box3 box;
    box.add(octree_.frame.position(cell.low));
    box.add(octree_.frame.position(corner_of(cell.low, size, 7)));
    return (*is_needless_)(box);
  }
  /// Whether the block has as many cells as are asked for at once.
  bool is_left_out(const LatticeCell& cell, int lattice_level) const {
    return lattice_level >= cell.level + 2 && is_left_out(cell);
  }

  void visit(std::size_t node, const LatticeCell& cell) {
    if (!meets(cell)) return;
    const std::int32_t child = octree_.child_of[node];
    if (child < 0) {
      const auto leaf = static_cast<std::size_t>(~child);
      const int lattice_level = octree_.lattice_level[leaf];
      if (lattice_level == cell.level) return emit(cell, octree_.owned_corners[leaf]);
      if (octree_.owned_corners[leaf] == owned_among_equals) {
        return visit_even_block(cell, lattice_level);
      }
      return visit_block(cell, cell, lattice_level);
    }
    if (is_left_out(cell)) return;
    const std::int32_t half = size_at_level(cell.level + 1);
    for (std::size_t k = 0; k < 8; ++k) {
      visit(static_cast<std::size_t>(child) + k, {cell.level + 1, corner_of(cell.low, half, k)});
    }
  }

  /// Among cells of one size each owns its corner 0 and its centre: nothing is looked up, and what
  /// holds no wanted node is counted without being visited.
  void visit_even_block(const LatticeCell& cell, int lattice_level) {
    if (meets(cell) && !is_left_out(cell, lattice_level)) enter_even_block(cell, lattice_level);
  }
  /// Of one that is known to be wanted.
  void enter_even_block(const LatticeCell& cell, int lattice_level) {
    const auto finer = static_cast<unsigned>(lattice_level - cell.level);
    if (is_inside(cell) && pass_over(std::size_t{2} << 3 * finer)) return;
    if (finer == 0) {
      emit(cell, owned_among_equals, true);
      return;
    }
    const std::int32_t half = size_at_level(cell.level + 1);
    for (std::size_t k = 0; k < 8; ++k) {
      visit_even_block({cell.level + 1, corner_of(cell.low, half, k)}, lattice_level);
    }
  }

  /// Whether every node of the cell is one that is asked for.
  bool is_inside(const LatticeCell& cell) const {
    if (plane_ != nullptr) return false;
    const std::int32_t size = size_at_level(cell.level);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (cell.low[axis] < first_[axis] || cell.low[axis] + size > last_[axis]) return false;
    }
    return true;
  }

  /// Counts that many nodes at once; false, and nothing is counted, when one of them is wanted.
  bool pass_over(std::size_t count) {
    if (purpose_ == Purpose::all || next_chosen() < seen_ + count) return false;
    seen_ += count;
    return true;
  }

  std::size_t next_chosen() const {
    return nodes_.size() < choice_.numbers.size() ? choice_.numbers[nodes_.size()]
                                                  : std::numeric_limits<std::size_t>::max();
  }

  /// Whether the cell touches no face of the block, so that only cells of the block touch it.
  static bool is_deep_in(const LatticeCell& cell, const LatticeCell& block) {
    const std::int32_t size = size_at_level(cell.level);
    const std::int32_t block_size = size_at_level(block.level);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int32_t low = cell.low[axis] - block.low[axis];
      if (low <= 0 || low + size >= block_size) return false;
    }
    return true;
  }

  void visit_block(const LatticeCell& cell, const LatticeCell& block, int lattice_level) {
    if (!meets(cell) || is_left_out(cell, lattice_level)) return;
    if (is_deep_in(cell, block)) return enter_even_block(cell, lattice_level);
    if (cell.level == lattice_level) {
      return emit(cell, looked_up([&] { return owned_in_block(cell, block); }));
    }
    if (cell.level > block.level && touches_equals_only(cell, lattice_level)) {
      return enter_even_block(cell, lattice_level);
    }
    const std::int32_t half = size_at_level(cell.level + 1);
    for (std::size_t k = 0; k < 8; ++k) {
      visit_block({cell.level + 1, corner_of(cell.low, half, k)}, block, lattice_level);
    }
  }

  /// A part of a block that is not even as a whole.
  bool touches_equals_only(const LatticeCell& cell, int lattice_level) {
    return looked_up([&] { return is_among_equals(octree_, cell, lattice_level) ? 1U : 0U; }) != 0;
  }

  /// Looked up once: both walks of a sample come to the same cells.
  template <class LookUp>
  unsigned looked_up(LookUp&& look_up) {
    if (purpose_ == Purpose::choice) return found_[next_found_++];
    const unsigned found = look_up();
    if (purpose_ == Purpose::count) found_.push_back(static_cast<std::uint8_t>(found));
    return found;
  }

  unsigned owned_in_block(const LatticeCell& cell, const LatticeCell& block) const {
    unsigned owned = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      if (owns_in_block(cell, k, block)) owned |= 1U << k;
    }
    return owned;
  }

  /// As owner_of has it, but most cells of a block are known without looking them up: they are as
  /// large as this one. Corner 0 comes first, as it wins among equals.
  bool owns_in_block(const LatticeCell& cell, std::size_t k, const LatticeCell& block) const {
    const std::int32_t block_size = size_at_level(block.level);
    const GridPoint node = corner_of(cell.low, size_at_level(cell.level), k);
    for (std::size_t other = 0; other < 8; ++other) {
      if (other == k) continue;
      bool is_in_octree = true;
      bool is_in_block = true;
      GridPoint p = node;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        p[axis] -= static_cast<int>((other >> axis) & 1U);
        const std::int32_t i = p[axis] - block.low[axis];
        is_in_block = is_in_block && i >= 0 && i < block_size;
        is_in_octree = is_in_octree && p[axis] >= 0 && p[axis] < octree_span;
      }
      if (is_in_block && other < k) return false;
      if (is_in_block || !is_in_octree) continue;
      const LatticeCell there = lattice_cell_at(octree_, p);
      const bool wins = there.level > cell.level || (there.level == cell.level && other < k);
      if (wins && corner_of(there.low, size_at_level(there.level), other) == node) return false;
    }
    return true;
  }

  /// Nodes among cells of one size are not shifted.
  void emit(const LatticeCell& cell, unsigned owned, bool is_among_equal_cells = false) {
    if (is_inside(cell) && pass_over(1 + static_cast<std::size_t>(std::popcount(owned)))) return;
    const std::int32_t size = size_at_level(cell.level);
    const double edge = size * octree_.frame.unit;
    const auto bits = static_cast<std::uint8_t>(octree_max_level + 1 - cell.level);
    for (std::size_t k = 0; k < 8; ++k) {
      const GridPoint corner = corner_of(cell.low, size, k);
      if ((owned >> k & 1U) == 0 || !is_wanted(corner)) continue;
      add({octree_.frame.position(corner), edge, corner, bits,
           is_among_equal_cells ? std::array<std::int8_t, 3>{}
                                : shift_to_coarser(octree_, corner, cell.level)});
    }
    const GridPoint centre = corner_of(cell.low, size / 2, 7);
    if (is_wanted(centre)) add({octree_.frame.position(centre), edge, centre, bits, {}});
  }

  /// To be asked once for each node.
  bool is_wanted(const GridPoint& p) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (p[axis] < first_[axis] || p[axis] > last_[axis]) return false;
    }
    if (plane_ != nullptr && !meets_plane(p, 0)) return false;
    return seen_++ == next_chosen() || purpose_ == Purpose::all;
  }

  void add(const LatticeNode& node) { nodes_.push_back(node); }

  const SpacingOctree& octree_;
  const LatticePlane* plane_;        // may be null
  const BoxPredicate* is_needless_;  // may be null
  LatticeVisits* visits_;            // may be null
  Purpose purpose_ = Purpose::all;
  std::size_t seen_ = 0;  // nodes so far, wanted or not
  SystematicSample choice_;
  std::vector<std::uint8_t> found_;  // by looked_up, in the order of the walk
  std::size_t next_found_ = 0;
  GridPoint first_{};
  GridPoint last_{};
  std::vector<LatticeNode> nodes_;
};

}  // namespace

std::vector<LatticeNode> lattice_nodes_in(const SpacingOctree& octree, const Box3& box,
                                          const LatticeFilter& filter) {
  return LatticeWalk(octree, box, filter).all();
}

LatticeSample sample_lattice_in(const SpacingOctree& octree, const Box3& box, std::size_t most) {
  return LatticeWalk(octree, box, {}).sample(most);
}

}  // namespace tetfarm
