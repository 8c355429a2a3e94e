#include "mesh/spacing/corner_spacing.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr std::size_t first_table_size = 1U << 12U;

std::size_t slot_of(std::uint64_t key, std::size_t table_size) {
  std::uint64_t h = key * 0x9e3779b97f4a7c15ULL;
  h ^= h >> 32U;
  return static_cast<std::size_t>(h) & (table_size - 1);
}

/// Number by number: comparing arrays calls memcmp, which took an eighth of the whole inspection.
bool is_same(const GridPoint& a, const GridPoint& b) {
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

}  // namespace

CornerSpacing::CornerSpacing() : table_(first_table_size, 0) {}

std::uint64_t CornerSpacing::key_of(const GridPoint& p) {
  // Corners are even and at most 2^21: halved, they have 21 bits.
  const auto half = [](std::int32_t i) { return static_cast<std::uint64_t>(i) >> 1U; };
  return half(p[0]) | half(p[1]) << 21U | half(p[2]) << 42U;
}

void CornerSpacing::grow_table() {
  table_.assign(2 * table_.size(), 0);
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    std::size_t slot = slot_of(key_of(corners_[c].at), table_.size());
    while (table_[slot] != 0) slot = (slot + 1) & (table_.size() - 1);
    table_[slot] = static_cast<std::uint32_t>(c + 1);
  }
}

std::uint32_t CornerSpacing::find_or_add(const GridPoint& p,
                                         const std::function<double(const GridPoint&)>& spacing) {
  if (2 * corners_.size() >= table_.size()) grow_table();
  std::size_t slot = slot_of(key_of(p), table_.size());
  for (; table_[slot] != 0; slot = (slot + 1) & (table_.size() - 1)) {
    if (is_same(corners_[table_[slot] - 1].at, p)) return table_[slot] - 1;
  }
  TF_CHECK(corners_.size() < unknown);
  corners_.push_back({p, spacing(p), 0, -1, 8, false});
  table_[slot] = static_cast<std::uint32_t>(corners_.size());
  return table_[slot] - 1;
}

void CornerSpacing::add_leaf(const LatticeCell& leaf, bool is_block, Numbers& numbers,
                             const std::function<double(const GridPoint&)>& spacing) {
  TF_CHECK(leaf.level >= 0 && leaf.level <= octree_max_level);
  for (std::size_t k = 0; k < 8; ++k) {
    if (numbers[k] == unknown) {
      numbers[k] = find_or_add(corner_of(leaf.low, size_at_level(leaf.level), k), spacing);
    }
    Corner& corner = corners_[numbers[k]];
    ++corner.touching_leaves;
    corner.touches_block = corner.touches_block || is_block;
    if (is_block || leaf.level < corner.owner_level) continue;
    if (leaf.level > corner.owner_level || k < corner.owner_corner) {
      corner.owner_level = static_cast<std::int8_t>(leaf.level);
      corner.owner_corner = static_cast<std::uint8_t>(k);
    }
  }
  has_blocks_ = has_blocks_ || is_block;
  leaves_.push_back(leaf);
  corners_of_leaf_.push_back(numbers);
}

void CornerSpacing::limit_growth(double growth, double unit) {
  TF_CHECK(growth > 0 && unit > 0);
  constexpr int most_passes = 100;
  bool changed = true;
  for (int pass = 0; pass < most_passes && changed; ++pass) {
    changed = false;
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
      const std::size_t leaf = pass % 2 == 0 ? i : leaves_.size() - 1 - i;
      const double edge = size_at_level(leaves_[leaf].level) * unit;
      for (std::size_t a = 0; a < 8; ++a) {
        for (std::size_t b = 0; b < 8; ++b) {
          const auto axes = static_cast<double>(__builtin_popcountll(a ^ b));
          const double limit = corners_[corners_of_leaf_[leaf][a]].spacing +
                               growth * edge * std::sqrt(axes) * (1 + 1e-9);
          double& spacing = corners_[corners_of_leaf_[leaf][b]].spacing;
          if (spacing <= limit) continue;
          spacing = limit;
          changed = true;
        }
      }
    }
  }
}

double CornerSpacing::interpolated(std::int32_t leaf, const GridPoint& p) const {
  const auto l = static_cast<std::size_t>(leaf);
  TF_CHECK(l < leaves_.size());
  const double size = size_at_level(leaves_[l].level);
  double sum = 0;
  for (std::size_t k = 0; k < 8; ++k) {
    double weight = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double t = (p[axis] - leaves_[l].low[axis]) / size;
      weight *= (k >> axis & 1U) != 0 ? t : 1 - t;
    }
    sum += weight * corners_[corners_of_leaf_[l][k]].spacing;
  }
  return sum;
}

void CornerSpacing::make_continuous(std::span<const std::int32_t> child_of) {
  // By the level of the coarse leaf: its own corners may hang on coarser ones still.
  std::array<std::vector<Hanging>, octree_max_level + 1> hanging;
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    if (corners_[c].touching_leaves == 8) continue;
    LeafAt coarsest{-1, {octree_max_level + 1, {}}};
    for (std::size_t k = 0; k < 8; ++k) {
      GridPoint p = corners_[c].at;
      for (std::size_t axis = 0; axis < 3; ++axis) p[axis] -= static_cast<int>(k >> axis & 1U);
      if (std::ranges::any_of(p, [](auto i) { return i < 0 || i >= octree_span; })) continue;
      const LeafAt found = leaf_at(child_of, p);
      if (found.cell.level >= coarsest.cell.level) continue;
      const std::int32_t size = size_at_level(found.cell.level);
      if (corner_of(found.cell.low, size, k) != corners_[c].at) coarsest = found;
    }
    if (coarsest.leaf < 0) continue;
    hanging[static_cast<std::size_t>(coarsest.cell.level)].push_back({c, coarsest.leaf});
  }
  for (const auto& level : hanging) {
    for (const Hanging& h : level) {
      corners_[h.corner].spacing = interpolated(h.leaf, corners_[h.corner].at);
    }
  }
}

std::vector<std::array<float, 8>> CornerSpacing::leaf_values() const {
  std::vector<std::array<float, 8>> values(leaves_.size());
  for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf) {
    for (std::size_t k = 0; k < 8; ++k) {
      values[leaf][k] = static_cast<float>(corners_[corners_of_leaf_[leaf][k]].spacing);
    }
  }
  return values;
}

/// Where blocks touch, whose lattice is finer than they are, or hold a corner in a side.
void CornerSpacing::settle_owners(const SpacingOctree& octree) {
  for (Corner& corner : corners_) {
    if (corner.touching_leaves == 8 && !corner.touches_block) continue;
    const LatticeCell owner = owner_of(octree, corner.at);
    TF_CHECK(owner.level >= 0);
    corner.owner_level = static_cast<std::int8_t>(owner.level);
    const GridPoint& at = corner.at;
    corner.owner_corner =
        static_cast<std::uint8_t>(static_cast<unsigned>(at[0] != owner.low[0]) |
                                  static_cast<unsigned>(at[1] != owner.low[1]) << 1U |
                                  static_cast<unsigned>(at[2] != owner.low[2]) << 2U);
  }
}

std::vector<std::uint8_t> CornerSpacing::owned_corners(const SpacingOctree& octree) {
  TF_CHECK(octree.lattice_level.size() == leaves_.size());
  if (has_blocks_) settle_owners(octree);
  std::vector<std::uint8_t> owned(leaves_.size(), 0);
  for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf) {
    if (octree.lattice_level[leaf] > leaves_[leaf].level) continue;
    unsigned mask = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      const Corner& corner = corners_[corners_of_leaf_[leaf][k]];
      if (corner.owner_level == leaves_[leaf].level && corner.owner_corner == k) mask |= 1U << k;
    }
    owned[leaf] = static_cast<std::uint8_t>(mask);
  }
  return owned;
}

}  // namespace tetfarm
