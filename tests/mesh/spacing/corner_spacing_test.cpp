#include "mesh/spacing/corner_spacing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <set>

#include "tests/support/chance.h"

namespace tetfarm {
namespace {

/// A tree whose nodes are split where `is_split` says so, with its leaves in Morton order.
struct Tree {
  std::vector<std::int32_t> child_of = {0};
  std::vector<LatticeCell> leaves;

  template <class IsSplit>
  explicit Tree(const IsSplit& is_split) {
    grow(0, {0, {}}, is_split);
  }

  std::vector<GridPoint> corners() const {
    std::set<GridPoint> corners;
    for (const LatticeCell& leaf : leaves) {
      for (std::size_t k = 0; k < 8; ++k) {
        corners.insert(corner_of(leaf.low, size_at_level(leaf.level), k));
      }
    }
    return {corners.begin(), corners.end()};
  }

 private:
  template <class IsSplit>
  void grow(std::size_t node, const LatticeCell& cell, const IsSplit& is_split) {
    if (!is_split(cell)) {
      child_of[node] = ~static_cast<std::int32_t>(leaves.size());
      leaves.push_back(cell);
      return;
    }
    const std::size_t first = child_of.size();
    child_of[node] = static_cast<std::int32_t>(first);
    child_of.resize(first + 8);
    for (std::size_t k = 0; k < 8; ++k) {
      grow(first + k, {cell.level + 1, corner_of(cell.low, size_at_level(cell.level + 1), k)},
           is_split);
    }
  }
};

Tree even_tree(int level) {
  return Tree([level](const LatticeCell& cell) { return cell.level < level; });
}

/// Cells of levels 2, 3 and 4: those at the low corner are split, and some in the middle.
Tree graded_tree() {
  return Tree([](const LatticeCell& cell) {
    if (cell.level < 2) return true;
    const std::int32_t size = size_at_level(cell.level);
    const auto touches = [&](std::int32_t low, std::int32_t high) {
      return std::all_of(cell.low.begin(), cell.low.end(),
                         [&](std::int32_t i) { return i <= high && i + size >= low; });
    };
    if (cell.level == 2) return touches(octree_span / 2, octree_span / 2);
    return cell.level == 3 && touches(octree_span / 2 + 1, octree_span / 2 + octree_span / 8);
  });
}

constexpr double unit = 1.0 / (1 << 21);

template <class Spacing>
CornerSpacing spacing_of(const Tree& tree, const Spacing& spacing) {
  CornerSpacing corners;
  for (const LatticeCell& leaf : tree.leaves) {
    CornerSpacing::Numbers numbers;
    numbers.fill(CornerSpacing::unknown);
    corners.add_leaf(leaf, false, numbers, spacing);
  }
  return corners;
}

/// The value at each corner of the leaves; fails where two leaves do not agree.
std::map<GridPoint, float> values_of(const Tree& tree, const CornerSpacing& corners) {
  std::map<GridPoint, float> values;
  const auto of_leaves = corners.leaf_values();
  EXPECT_EQ(of_leaves.size(), tree.leaves.size());
  for (std::size_t leaf = 0; leaf < tree.leaves.size(); ++leaf) {
    const LatticeCell& cell = tree.leaves[leaf];
    for (std::size_t k = 0; k < 8; ++k) {
      const GridPoint at = corner_of(cell.low, size_at_level(cell.level), k);
      const auto [known, is_new] = values.try_emplace(at, of_leaves[leaf][k]);
      EXPECT_EQ(known->second, of_leaves[leaf][k]);
    }
  }
  return values;
}

TEST(CornerSpacing, asks_at_each_corner_once_however_many_there_are) {
  for (const Tree& tree : {even_tree(1), graded_tree(), even_tree(4)}) {
    std::multiset<GridPoint> asked;
    const CornerSpacing corners = spacing_of(tree, [&](const GridPoint& p) {
      asked.insert(p);
      return static_cast<double>(asked.size());
    });
    const std::vector<GridPoint> expected = tree.corners();
    EXPECT_TRUE(std::equal(asked.begin(), asked.end(), expected.begin(), expected.end()));
    EXPECT_EQ(values_of(tree, corners).size(), expected.size());
  }
  EXPECT_EQ(even_tree(4).corners().size(), 17U * 17 * 17);
}

TEST(CornerSpacing, does_not_look_up_the_numbers_that_are_known) {
  const Tree tree = even_tree(1);
  CornerSpacing corners;
  int asked = 0;
  const auto spacing = [&asked](const GridPoint&) { return static_cast<double>(++asked); };
  CornerSpacing::Numbers numbers;
  numbers.fill(CornerSpacing::unknown);
  corners.add_leaf(tree.leaves[0], false, numbers, spacing);
  EXPECT_EQ(asked, 8);
  // The second leaf begins where the first one ends along x.
  CornerSpacing::Numbers next;
  next.fill(CornerSpacing::unknown);
  for (std::size_t k = 0; k < 8; k += 2) next[k] = numbers[k + 1];
  corners.add_leaf(tree.leaves[1], false, next, spacing);
  EXPECT_EQ(asked, 12);
  EXPECT_EQ(std::count(next.begin(), next.end(), CornerSpacing::unknown), 0);
}

TEST(CornerSpacing, grows_from_corner_to_corner_as_along_the_shortest_way) {
  const Tree tree = graded_tree();
  shapes::Chance chance(3);
  std::map<GridPoint, double> asked;
  CornerSpacing corners = spacing_of(tree, [&](const GridPoint& p) {
    return asked[p] = chance.pick(0, 9) == 0 ? chance.between(0.01, 0.1) : chance.between(0.3, 2);
  });
  constexpr double growth = 0.3;
  corners.limit_growth(growth, unit);
  const std::map<GridPoint, float> limited = values_of(tree, corners);
  // Every corner's value, passed on within leaves until nothing changes.
  std::map<GridPoint, double> expected = asked;
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (const LatticeCell& cell : tree.leaves) {
      const std::int32_t size = size_at_level(cell.level);
      for (std::size_t a = 0; a < 8; ++a) {
        for (std::size_t b = 0; b < 8; ++b) {
          const double way = size * unit * std::sqrt(std::popcount(a ^ b));
          const double limit = expected[corner_of(cell.low, size, a)] + growth * way;
          double& value = expected[corner_of(cell.low, size, b)];
          if (value <= limit * (1 + 1e-12)) continue;
          value = limit;
          has_changed = true;
        }
      }
    }
  }
  std::size_t lowered = 0;
  for (const auto& [p, value] : limited) {
    EXPECT_NEAR(value, expected[p], 1e-6);
    lowered += value < 0.999 * asked[p] ? 1U : 0U;
  }
  EXPECT_GT(lowered, limited.size() / 4);
}

/// Of whole sixteenths, which floats and means of eight hold exactly.
double linear(const GridPoint& p) { return 1 + unit * (2.0 * p[0] + 3.0 * p[1] - 0.5 * p[2]); }

TEST(CornerSpacing, that_is_linear_stays_as_it_is_where_corners_hang) {
  const Tree tree = graded_tree();
  CornerSpacing corners = spacing_of(tree, linear);
  corners.make_continuous(tree.child_of);
  for (const auto& [p, value] : values_of(tree, corners)) EXPECT_EQ(value, linear(p));
}

/// The value that a leaf interpolates.
double interpolated(const LatticeCell& leaf, const GridPoint& p,
                    const std::map<GridPoint, float>& values) {
  const std::int32_t size = size_at_level(leaf.level);
  double sum = 0;
  for (std::size_t k = 0; k < 8; ++k) {
    double weight = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double share = static_cast<double>(p[axis] - leaf.low[axis]) / size;
      weight *= (k >> axis & 1U) != 0 ? share : 1 - share;
    }
    sum += weight * values.at(corner_of(leaf.low, size, k));
  }
  return sum;
}

TEST(CornerSpacing, is_the_same_from_all_leaves_that_touch_a_corner) {
  const Tree tree = graded_tree();
  shapes::Chance chance(8);
  std::map<GridPoint, double> asked;
  CornerSpacing corners =
      spacing_of(tree, [&](const GridPoint& p) { return asked[p] = chance.pick(1, 1 << 12); });
  corners.make_continuous(tree.child_of);
  const std::map<GridPoint, float> values = values_of(tree, corners);
  std::size_t hanging = 0;
  for (const auto& [p, value] : values) {
    bool hangs = false;
    for (const LatticeCell& leaf : tree.leaves) {
      const std::int32_t size = size_at_level(leaf.level);
      bool touches = true;
      bool is_corner = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int32_t i = p[axis] - leaf.low[axis];
        touches = touches && i >= 0 && i <= size;
        is_corner = is_corner && (i == 0 || i == size);
      }
      if (!touches) continue;
      EXPECT_NEAR(interpolated(leaf, p, values), value, 1e-2);
      hangs = hangs || !is_corner;
    }
    if (hangs) {
      ++hanging;
    } else {
      EXPECT_EQ(value, asked[p]);
    }
  }
  EXPECT_GT(hanging, 50U);
}

SpacingOctree octree_of(const Tree& tree) {
  SpacingOctree octree;
  octree.child_of = tree.child_of;
  octree.values.resize(tree.leaves.size(), {1, 1, 1, 1, 1, 1, 1, 1});
  for (const LatticeCell& leaf : tree.leaves) {
    octree.lattice_level.push_back(static_cast<std::uint8_t>(leaf.level));
  }
  return octree;
}

TEST(CornerSpacing, gives_each_corner_the_owner_that_the_octree_tells) {
  const Tree tree = graded_tree();
  const SpacingOctree octree = octree_of(tree);
  CornerSpacing corners = spacing_of(tree, linear);
  const std::vector<std::uint8_t> owned = corners.owned_corners(octree);
  std::map<GridPoint, int> owners;
  for (std::size_t leaf = 0; leaf < tree.leaves.size(); ++leaf) {
    const LatticeCell& cell = tree.leaves[leaf];
    for (std::size_t k = 0; k < 8; ++k) {
      if ((owned[leaf] >> k & 1U) == 0) continue;
      const GridPoint p = corner_of(cell.low, size_at_level(cell.level), k);
      ++owners[p];
      const LatticeCell owner = owner_of(octree, p);
      EXPECT_EQ(owner.level, cell.level);
      EXPECT_EQ(owner.low, cell.low);
    }
  }
  EXPECT_EQ(owners.size(), tree.corners().size());
  for (const auto& [p, count] : owners) EXPECT_EQ(count, 1);
}

TEST(CornerSpacing, leaves_what_blocks_touch_to_their_finer_lattice) {
  const Tree tree = even_tree(1);
  SpacingOctree octree = octree_of(tree);
  octree.lattice_level[0] = 2;
  CornerSpacing corners;
  for (std::size_t leaf = 0; leaf < 8; ++leaf) {
    CornerSpacing::Numbers numbers;
    numbers.fill(CornerSpacing::unknown);
    corners.add_leaf(tree.leaves[leaf], leaf == 0, numbers, linear);
  }
  const std::vector<std::uint8_t> owned = corners.owned_corners(octree);
  EXPECT_EQ(owned[0], 0);
  for (std::size_t leaf = 1; leaf < 8; ++leaf) {
    for (std::size_t k = 0; k < 8; ++k) {
      const GridPoint p = corner_of(tree.leaves[leaf].low, octree_span / 2, k);
      const LatticeCell owner = owner_of(octree, p);
      const bool owns = owner.level == 1 && owner.low == tree.leaves[leaf].low;
      EXPECT_EQ((owned[leaf] >> k & 1U) != 0, owns);
    }
  }
}

}  // namespace
}  // namespace tetfarm
