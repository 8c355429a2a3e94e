#include "mesh/filling/lattice_grid.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

constexpr int coordinate_bits = 19;  // of a block: grid points have 22 bits, the least size is 2

std::uint64_t block_key(int shift, const std::array<std::int32_t, 3>& block) {
  std::uint64_t key = static_cast<std::uint64_t>(shift);
  for (const std::int32_t i : block) {
    key = key << coordinate_bits | (static_cast<std::uint64_t>(i) & ((1U << coordinate_bits) - 1));
  }
  return key;
}

/// From the key of a block to its number; open addressing.
class BlockTable {
 public:
  BlockTable() : entries_(1024, LatticeGrid::none) {}

  /// The number of the block with this key, or none.
  std::int32_t find(const std::vector<std::uint64_t>& keys, std::uint64_t key) const {
    return entries_[place_of(keys, key)];
  }
  void add(const std::vector<std::uint64_t>& keys) {
    if (2 * keys.size() > entries_.size()) {
      entries_.assign(2 * entries_.size(), LatticeGrid::none);
      for (std::size_t i = 0; i + 1 < keys.size(); ++i) put(keys, i);
    }
    put(keys, keys.size() - 1);
  }

 private:
  std::size_t place_of(const std::vector<std::uint64_t>& keys, std::uint64_t key) const {
    std::size_t place = (key * 0x9E3779B97F4A7C15U) >> 20U & (entries_.size() - 1);
    while (entries_[place] >= 0 && keys[at(entries_[place])] != key) {
      place = (place + 1) & (entries_.size() - 1);
    }
    return place;
  }
  void put(const std::vector<std::uint64_t>& keys, std::size_t number) {
    entries_[place_of(keys, keys[number])] = static_cast<std::int32_t>(number);
  }

  std::vector<std::int32_t> entries_;
};

/// The cell of a node: of the centre that cell, of a corner the one whose low corner it is.
struct CellOfNode {
  std::array<std::int32_t, 3> cell;  // in cells of its size
  int shift;                         // of the size
  bool is_centre;
};

CellOfNode cell_of(const LatticeNode& node) {
  const int shift = node.cell_bits;
  return {{node.grid[0] >> shift, node.grid[1] >> shift, node.grid[2] >> shift},
          shift,
          (node.grid[0] & (node.cell_size() - 1)) != 0};
}

}  // namespace

LatticeGrid::LatticeGrid(std::span<const LatticeNode> nodes) {
  BlockTable table;
  TF_CHECK(nodes.size() < (std::size_t{1} << 31U));
  std::vector<std::uint64_t> keys;
  std::int32_t last = none;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const CellOfNode place = cell_of(nodes[i]);
    const auto& c = place.cell;
    const std::uint64_t key =
        block_key(place.shift, {c[0] >> block_bits, c[1] >> block_bits, c[2] >> block_bits});
    if (last == none || keys[at(last)] != key) {
      last = table.find(keys, key);
      if (last == none) {
        last = static_cast<std::int32_t>(keys.size());
        keys.push_back(key);
        table.add(keys);
        slots_.resize(slots_.size() + slots_in_block);
      }
    }
    Slot& slot = slots_[at(last * slots_in_block + local_slot(c[0], c[1], c[2]))];
    (place.is_centre ? slot.centre : slot.low_corner) = static_cast<std::int32_t>(i);
  }
  blocks_.resize(keys.size());
  for (std::size_t b = 0; b < keys.size(); ++b) {
    constexpr std::uint64_t mask = (1U << coordinate_bits) - 1;
    const auto shift = static_cast<int>(keys[b] >> (3 * coordinate_bits));
    const auto coordinate = [&](int axis) {
      return static_cast<std::int32_t>(keys[b] >> ((2 - axis) * coordinate_bits) & mask);
    };
    for (std::int32_t n = 0; n < 27; ++n) {
      const std::array<std::int32_t, 3> beside = {
          coordinate(0) + n % 3 - 1, coordinate(1) + n / 3 % 3 - 1, coordinate(2) + n / 9 - 1};
      blocks_[b].neighbours[at(n)] = table.find(keys, block_key(shift, beside));
    }
  }
  find_deep_blocks();
}

void LatticeGrid::find_deep_blocks() {
  std::vector<std::uint8_t> is_full(blocks_.size(), 0);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const auto first = slots_.begin() + static_cast<std::ptrdiff_t>(b) * slots_in_block;
    is_full[b] = std::all_of(first, first + slots_in_block,
                             [](const Slot& slot) { return slot.centre != none; })
                     ? 1
                     : 0;
  }
  for (Block& block : blocks_) {
    block.is_deep = std::all_of(block.neighbours.begin(), block.neighbours.end(),
                                [&](std::int32_t b) { return b != none && is_full[at(b)] != 0; });
  }
}

}  // namespace tetfarm
