/// Finds the nodes of the graded lattice by their place: dense blocks of cells of one size.
///
/// A *slot* stands for one cell of one size: the node at its centre and the node at its low corner.
/// Blocks hold 4 x 4 x 4 slots, so that neighbours lie near each other in memory. Cost: O(nodes),
/// 10 to 30 bytes a node; a step to a neighbour some nanoseconds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

class LatticeGrid {
 public:
  static constexpr std::int32_t none = -1;
  static constexpr std::int32_t slots_in_block = 64;

  /// No slots.
  LatticeGrid() = default;
  explicit LatticeGrid(std::span<const LatticeNode> nodes);

  std::int32_t slot_count() const { return static_cast<std::int32_t>(slots_.size()); }
  /// The node at the centre of the cell, and at its low corner when no smaller cell has it; none
  /// when there is no such node.
  std::int32_t centre(std::int32_t slot) const { return slot_at(slot).centre; }
  std::int32_t low_corner(std::int32_t slot) const { return slot_at(slot).low_corner; }
  /// The slot of the cell of the same size that lies x, y, z cells further, each -1, 0 or 1; none
  /// when no node is near.
  std::int32_t neighbour(std::int32_t slot, int x, int y, int z) const {
    const std::int32_t local = slot & (slots_in_block - 1);
    const std::int32_t i = (local & block_mask) + x;
    const std::int32_t j = (local >> block_bits & block_mask) + y;
    const std::int32_t k = (local >> (2 * block_bits)) + z;
    // 0, 1 or 2: the block before, this one, the one after.
    const std::int32_t across =
        ((i + 4) >> block_bits) + 3 * ((j + 4) >> block_bits) + 9 * ((k + 4) >> block_bits);
    const std::int32_t block = blocks_[static_cast<std::size_t>(slot / slots_in_block)]
                                   .neighbours[static_cast<std::size_t>(across)];
    return block < 0 ? none : block * slots_in_block + local_slot(i, j, k);
  }
  /// Whether this block and the 26 round it have a node at every centre.
  bool is_deep(std::int32_t block) const {
    return blocks_[static_cast<std::size_t>(block)].is_deep;
  }
  /// The node at corner k of the cell (x, y, z in bits 0, 1, 2), or none.
  std::int32_t corner(std::int32_t slot, std::size_t k) const {
    const std::int32_t owner =
        neighbour(slot, static_cast<int>(k & 1U), static_cast<int>(k >> 1 & 1U),
                  static_cast<int>(k >> 2 & 1U));
    return owner == none ? none : low_corner(owner);
  }

 private:
  struct Slot {
    std::int32_t centre = none;
    std::int32_t low_corner = none;
  };
  struct Block {
    std::array<std::int32_t, 27> neighbours;
    bool is_deep = false;
  };

  static constexpr int block_bits = 2;
  static constexpr std::int32_t block_mask = (1 << block_bits) - 1;

  static std::int32_t local_slot(std::int32_t x, std::int32_t y, std::int32_t z) {
    return (x & block_mask) | (y & block_mask) << block_bits | (z & block_mask) << (2 * block_bits);
  }
  const Slot& slot_at(std::int32_t slot) const { return slots_[static_cast<std::size_t>(slot)]; }

  void find_deep_blocks();

  std::vector<Slot> slots_;
  std::vector<Block> blocks_;
};

}  // namespace tetfarm
