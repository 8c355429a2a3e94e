// The walk over the lattice, against all corners and centres of all its cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/spacing/octree_build.h"
#include "mesh/spacing/spacing_octree.h"
#include "mesh/spacing/systematic_sample.h"

namespace tetfarm {
namespace {

/// A small source; with a background there are blocks.
SpacingOctree octree_round_a_source(double background) {
  const double reference = background > 0 ? background : 0.3;
  SpacingDemand demand{DemandTree({}, 0.5), {}, background, 0.5, background > 0 ? background : 1};
  const double smallest = background > 0 ? 0.2 * background : 0.02;
  demand.sources.push_back(source_demand({{{{0.21, 0.33, 0.4}, smallest, 0.03, 0.1}}}, 0.5));
  Box3 domain;
  domain.add(Vec3{0, 0, 0});
  domain.add(Vec3{1, 1, 1});
  return build_octree(demand, grid_frame(domain, reference), domain);
}

/// The level of the cell that each node is of, found cell by cell from what owns its corners.
class AllNodes {
 public:
  explicit AllNodes(const SpacingOctree& octree) : octree_(octree) { visit(0, {0, {}}); }

  std::map<GridPoint, int> level_of_node;

 private:
  void visit(std::size_t node, const LatticeCell& cell) {
    const std::int32_t child = octree_.child_of[node];
    if (child < 0) {
      return visit_block(cell, octree_.lattice_level[static_cast<std::size_t>(~child)]);
    }
    for (std::size_t k = 0; k < 8; ++k) {
      visit(static_cast<std::size_t>(child) + k, half_of(cell, k));
    }
  }
  void visit_block(const LatticeCell& cell, int lattice_level) {
    if (cell.level == lattice_level) return add(cell);
    for (std::size_t k = 0; k < 8; ++k) visit_block(half_of(cell, k), lattice_level);
  }
  void add(const LatticeCell& cell) {
    const std::int32_t size = size_at_level(cell.level);
    level_of_node[corner_of(cell.low, size / 2, 7)] = cell.level;
    for (std::size_t k = 0; k < 8; ++k) {
      const GridPoint corner = corner_of(cell.low, size, k);
      const LatticeCell owner = owner_of(octree_, corner);
      if (owner.level == cell.level && owner.low == cell.low) level_of_node[corner] = cell.level;
    }
  }
  static LatticeCell half_of(const LatticeCell& cell, std::size_t k) {
    return {cell.level + 1, corner_of(cell.low, size_at_level(cell.level + 1), k)};
  }

  const SpacingOctree& octree_;
};

bool is_in(const Box3& box, const Vec3& p) {
  for (int axis = 0; axis < 3; ++axis) {
    if (p[axis] < box.low[axis] || p[axis] > box.high[axis]) return false;
  }
  return true;
}

/// Its corners are places of the grid, so that nodes lie in its sides.
Box3 part_of_the_domain(const SpacingOctree& octree) {
  const auto place = [&octree](double x, double y, double z) {
    const auto coordinate = [&](double p, std::size_t axis) {
      const double unit = size_at_level(5) * octree.frame.unit;
      const double low = octree.frame.coordinate(axis, 0);
      return low + unit * std::round((p - low) / unit);
    };
    return Vec3{coordinate(x, 0), coordinate(y, 1), coordinate(z, 2)};
  };
  Box3 box;
  box.add(place(0.1, 0.2, 0.3));
  box.add(place(0.6, 0.55, 0.9));
  return box;
}

TEST(LatticeWalk, finds_each_node_in_a_box_once_with_the_size_of_its_cell) {
  for (const double background : {0.0, 0.08, 0.05}) {
    const SpacingOctree octree = octree_round_a_source(background);
    const Box3 box = part_of_the_domain(octree);
    std::map<GridPoint, int> wanted = AllNodes(octree).level_of_node;
    std::erase_if(wanted,
                  [&](const auto& node) { return !is_in(box, octree.frame.position(node.first)); });
    std::map<GridPoint, int> found;
    for (const LatticeNode& node : lattice_nodes_in(octree, box)) {
      const int level = octree_max_level + 1 - node.cell_bits;
      EXPECT_TRUE(found.emplace(node.grid, level).second) << "twice";
      EXPECT_EQ(node.cell_edge, size_at_level(level) * octree.frame.unit);
      EXPECT_EQ(node.at, octree.frame.position(node.grid));
    }
    EXPECT_GT(found.size(), 500U);
    EXPECT_TRUE(found == wanted) << background;
  }
}

TEST(LatticeWalk, of_a_plane_has_the_nodes_that_lie_in_it) {
  const SpacingOctree octree = octree_round_a_source(0.08);
  const Box3 box = part_of_the_domain(octree);
  const std::vector<LatticeNode> all = lattice_nodes_in(octree, box);
  for (const std::int32_t sign : {1, -1}) {
    LatticePlane plane;
    plane.axis = 2;
    plane.other_axis = 0;
    plane.sign = sign;
    const auto sum_at = [&](const GridPoint& p) { return p[2] + sign * p[0]; };
    plane.sum = sum_at(all[all.size() / 2].grid);
    std::vector<GridPoint> wanted;
    for (const LatticeNode& node : all) {
      if (sum_at(node.grid) == plane.sum) wanted.push_back(node.grid);
    }
    std::vector<GridPoint> found;
    for (const LatticeNode& node : lattice_nodes_in(octree, box, {.plane = &plane})) {
      found.push_back(node.grid);
    }
    EXPECT_GT(found.size(), 10U);
    EXPECT_EQ(found, wanted);
  }
}

TEST(LatticeWalk, leaves_out_nothing_but_what_is_needless) {
  const SpacingOctree octree = octree_round_a_source(0.08);
  const Box3 box = part_of_the_domain(octree);
  const BoxPredicate is_far = [](const Box3& cells) { return cells.low.x > 0.4; };
  std::vector<GridPoint> kept;
  for (const LatticeNode& node : lattice_nodes_in(octree, box, {.is_needless = &is_far})) {
    kept.push_back(node.grid);
  }
  std::sort(kept.begin(), kept.end());
  std::size_t near = 0;
  const std::vector<LatticeNode> all = lattice_nodes_in(octree, box);
  for (const LatticeNode& node : all) {
    if (node.at.x > 0.4) continue;
    ++near;
    EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), node.grid));
  }
  EXPECT_GE(kept.size(), near);
  EXPECT_LT(kept.size(), all.size());
}

TEST(LatticeWalk, samples_the_nodes_that_are_chosen_among_all_of_them) {
  for (const double background : {0.0, 0.08}) {
    const SpacingOctree octree = octree_round_a_source(background);
    const Box3 box = part_of_the_domain(octree);
    const std::vector<LatticeNode> all = lattice_nodes_in(octree, box);
    for (const std::size_t most : {std::size_t{1}, std::size_t{37}, std::size_t{400}, all.size()}) {
      const LatticeSample sample = sample_lattice_in(octree, box, most);
      const SystematicSample choice = systematic_sample(all.size(), most);
      ASSERT_EQ(sample.nodes.size(), choice.numbers.size());
      EXPECT_EQ(sample.nodes_for_each, static_cast<double>(choice.stride));
      for (std::size_t i = 0; i < choice.numbers.size(); ++i) {
        EXPECT_EQ(sample.nodes[i].grid, all[choice.numbers[i]].grid);
      }
    }
  }
}

}  // namespace
}  // namespace tetfarm
