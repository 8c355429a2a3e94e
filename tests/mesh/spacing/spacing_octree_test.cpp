#include "mesh/spacing/spacing_octree.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/spacing/octree_build.h"
#include "mesh/spacing/octree_refine.h"
#include "mesh/spacing/systematic_sample.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

struct Trial {
  SpacingDemand demand;
  Box3 domain;
  GridFrame frame;
};

/// A small source in a corner region of a cube; with a background there are blocks.
Trial corner_source(double background) {
  Trial trial{{DemandTree({}, 0.5), {}, background, 0.5, background > 0 ? background : 1}, {}, {}};
  trial.domain.add(Vec3{0, 0, 0});
  trial.domain.add(Vec3{1, 1, 1});
  const Source source{{{{0.21, 0.33, 0.4}, 0.004, 0.01, 0.02}}};
  trial.demand.sources.push_back(source_demand(source, 0.5));
  trial.frame = grid_frame(trial.domain, background > 0 ? background : 0.3);
  return trial;
}

SpacingOctree octree_of(const Trial& trial) {
  return build_octree(trial.demand, trial.frame, trial.domain);
}

/// Calls visit(leaf, cell) for each leaf.
template <typename Visit>
void for_each_leaf(const SpacingOctree& octree, std::size_t node, const LatticeCell& cell,
                   const Visit& visit) {
  const std::int32_t child = octree.child_of[node];
  if (child < 0) {
    visit(static_cast<std::size_t>(~child), cell);
    return;
  }
  for (std::size_t k = 0; k < 8; ++k) {
    for_each_leaf(octree, static_cast<std::size_t>(child) + k,
                  {cell.level + 1, corner_of(cell.low, size_at_level(cell.level + 1), k)}, visit);
  }
}

TEST(GridFrame, is_exact_and_holds_the_domain) {
  for (const double spacing : {0.001, 0.07, 1.0, 3.7, 1000.0}) {
    const Box3 domain = bounding_box(shapes::sphere({1000, -3, 0.1}, 2.5, 1).vertices);
    const GridFrame frame = grid_frame(domain, spacing);
    const Vec3 low = frame.position({0, 0, 0});
    const Vec3 high = frame.position({octree_span, octree_span, octree_span});
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LT(low[axis], domain.low[axis]);
      EXPECT_GT(high[axis], domain.high[axis]);
      EXPECT_LT(high[axis] - low[axis], 2.05 * 5);
    }
    const double a = frame.coordinate(0, 12345);
    EXPECT_EQ((frame.coordinate(0, 12346) - a) + (a - frame.coordinate(0, 12344)), 2 * frame.unit);
    const double steps = std::log2(spacing / 0.92 / frame.unit);
    EXPECT_NEAR(steps, std::round(steps), 1e-5);
  }
}

TEST(SpacingOctree, keeps_its_invariants) {
  for (const double background : {0.0, 0.02, 0.1}) {
    EXPECT_EQ(validate(octree_of(corner_source(background))), nullptr);
  }
}

TEST(SpacingOctree, is_balanced_across_corners) {
  for (const double background : {0.0, 0.02, 0.1}) {
    const SpacingOctree octree = octree_of(corner_source(background));
    for_each_leaf(octree, 0, {0, {}}, [&](std::size_t leaf, const LatticeCell& cell) {
      if (octree.lattice_level[leaf] != cell.level) return;
      const std::int32_t size = size_at_level(cell.level);
      for (std::int32_t n = 0; n < 27; ++n) {
        const GridPoint p{cell.low[0] + (n % 3 - 1) * size, cell.low[1] + (n / 3 % 3 - 1) * size,
                          cell.low[2] + (n / 9 - 1) * size};
        if (p[0] < 0 || p[1] < 0 || p[2] < 0) continue;
        if (p[0] >= octree_span || p[1] >= octree_span || p[2] >= octree_span) continue;
        const LeafAt other = leaf_at(octree.child_of, p);
        const int level = octree.lattice_level[static_cast<std::size_t>(other.leaf)];
        EXPECT_GE(level, cell.level - 1);
      }
    });
  }
}

TEST(SpacingOctree, keeps_the_background_in_blocks) {
  const SpacingOctree octree = octree_of(corner_source(0.004001));
  // Some 12 million lattice cells.
  EXPECT_LT(octree.leaf_count(), 200000);
}

TEST(SpacingOctree, has_cells_that_follow_the_spacing) {
  const Trial trial = corner_source(0);
  const SpacingOctree octree = octree_of(trial);
  for_each_leaf(octree, 0, {0, {}}, [&](std::size_t, const LatticeCell& cell) {
    const Vec3 centre = trial.frame.position(corner_of(cell.low, size_at_level(cell.level) / 2, 7));
    const double wanted = source_value(trial.demand.sources[0], centre, 0, 0, 0.5).asked;
    const double edge = size_at_level(cell.level) * trial.frame.unit;
    Box3 here;
    here.add(centre);
    if (!here.overlaps(trial.domain)) return;
    EXPECT_LE(edge, cell_fit / lattice_ratio * wanted * (1 + 1e-12));
  });
}

TEST(SpacingOctree, gives_each_node_one_owner_as_owner_of_says) {
  const SpacingOctree octree = octree_of(corner_source(0.1));
  for_each_leaf(octree, 0, {0, {}}, [&](std::size_t leaf, const LatticeCell& cell) {
    if (octree.lattice_level[leaf] != cell.level) return;
    for (std::size_t k = 0; k < 8; ++k) {
      const GridPoint node = corner_of(cell.low, size_at_level(cell.level), k);
      const LatticeCell owner = owner_of(octree, node);
      const bool owns = owner.level == cell.level && owner.low == cell.low;
      EXPECT_EQ(owns, (octree.owned_corners[leaf] >> k & 1) != 0);
    }
  });
}

TEST(SpacingOctree, validate_finds_what_is_broken) {
  const SpacingOctree sound = octree_of(corner_source(0.1));
  SpacingOctree broken = sound;
  broken.child_of[0] = static_cast<std::int32_t>(broken.child_of.size());
  EXPECT_NE(validate(broken), nullptr);
  broken = sound;
  broken.child_of[broken.child_of.size() - 1] = 1;
  EXPECT_NE(validate(broken), nullptr);
  broken = sound;
  broken.values[3][2] = -1;
  EXPECT_NE(validate(broken), nullptr);
  broken = sound;
  broken.lattice_level[broken.lattice_level.size() - 1] = 0;
  EXPECT_NE(validate(broken), nullptr);
  broken = sound;
  broken.owned_corners.resize(broken.owned_corners.size() - 1);
  EXPECT_NE(validate(broken), nullptr);
  broken = sound;
  broken.frame.unit = 0;
  EXPECT_NE(validate(broken), nullptr);
}

TEST(SpacingOctree, samples_the_chosen_ones_of_its_lattice_nodes) {
  const SpacingOctree octree = octree_of(corner_source(0.02));
  Box3 box;
  box.add(Vec3{0.1, 0.2, 0.3});
  box.add(Vec3{0.9, 0.5, 0.7});
  const std::vector<LatticeNode> all = lattice_nodes_in(octree, box);
  for (const std::size_t most : {std::size_t{100}, std::size_t{5000}, 2 * all.size()}) {
    const SystematicSample choice = systematic_sample(all.size(), most);
    const LatticeSample sample = sample_lattice_in(octree, box, most);
    EXPECT_EQ(sample.nodes_for_each, static_cast<double>(choice.stride));
    ASSERT_EQ(sample.nodes.size(), choice.numbers.size());
    for (std::size_t i = 0; i < sample.nodes.size(); ++i) {
      EXPECT_EQ(sample.nodes[i].grid, all[choice.numbers[i]].grid);
      EXPECT_EQ(sample.nodes[i].shift, all[choice.numbers[i]].shift);
    }
  }
}

}  // namespace
}  // namespace tetfarm
