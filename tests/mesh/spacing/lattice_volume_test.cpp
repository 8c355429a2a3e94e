#include "mesh/spacing/lattice_volume.h"

#include <gtest/gtest.h>

#include "mesh/spacing/octree_build.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

const Box3 unit_box{{0, 0, 0}, {1, 1, 1}};

bool holds(const Box3& box, const Vec3& p) { return box.overlaps({p, p}); }

/// Nothing but a background.
SpacingOctree even_octree(double background) {
  const SpacingDemand demand{DemandTree({}, 0.5), {}, background, 0.5, background};
  return build_octree(demand, grid_frame(unit_box, background), unit_box);
}

/// A source in a background that is kept in blocks.
SpacingOctree graded_octree(double background) {
  SpacingDemand demand{DemandTree({}, 0.5), {}, background, 0.5, background};
  const double fine = background / 5;
  demand.sources.push_back(source_demand({{{{0.21, 0.33, 0.4}, fine, 0.05, 0.1}}}, 0.5));
  return build_octree(demand, grid_frame(unit_box, background), unit_box);
}

double nodes_of(const LatticeSample& sample) {
  return sample.nodes_for_each * static_cast<double>(sample.nodes.size());
}

TEST(LatticeVolume, comes_to_the_number_of_nodes) {
  const SpacingOctree octree = graded_octree(0.02);
  for (const Box3& box : {unit_box, Box3{{0.1, 0.2, 0.3}, {0.35, 0.9, 0.5}}}) {
    const auto nodes = static_cast<double>(lattice_nodes_in(octree, box).size());
    const LatticeSample sample = sample_by_volume(octree, box, 1000);
    EXPECT_EQ(sample.nodes.size(), 1000U);
    EXPECT_NEAR(nodes_of(sample), nodes, 0.1 * nodes);
  }
}

TEST(LatticeVolume, has_as_many_points_at_a_place_as_the_lattice_has_nodes) {
  const SpacingOctree octree = graded_octree(0.02);
  const Box3 round_source{{0.15, 0.27, 0.34}, {0.27, 0.39, 0.46}};
  const auto share = [&](const std::vector<LatticeNode>& nodes) {
    double inside = 0;
    for (const LatticeNode& node : nodes) {
      EXPECT_TRUE(holds(unit_box, node.at));
      EXPECT_EQ(node.cell_edge, octree.lattice_cell_edge(node.at));
      if (holds(round_source, node.at)) ++inside;
    }
    return inside / static_cast<double>(nodes.size());
  };
  std::vector<LatticeNode> all = lattice_nodes_in(octree, unit_box);
  for (LatticeNode& node : all) node.cell_edge = octree.lattice_cell_edge(node.at);
  const double expected = share(all);
  EXPECT_GT(expected, 0.05) << "thirty times its share of the volume";
  EXPECT_NEAR(share(sample_by_volume(octree, unit_box, 10'000).nodes), expected, 0.01);
}

TEST(LatticeVolume, is_taken_where_the_lattice_cannot_be_walked) {
  const SurfaceMesh cube = shapes::box({0, 0, 0}, {1, 1, 1}, 4);
  for (const double h : {1e-4, 1e-6}) {
    SpacingOptions options;
    options.background = h;
    const SpacingField field = make_spacing_field(cube, options);
    const double edge = field.lattice_cell_edge({0.5, 0.5, 0.5});
    const LatticeSample sample = field.sample_lattice(unit_box, 5000);
    EXPECT_EQ(sample.nodes.size(), 5000U);
    EXPECT_NEAR(nodes_of(sample), 2 / (edge * edge * edge), 1e-3 / (edge * edge * edge)) << h;
  }
}

TEST(LatticeVolume, knows_what_a_walk_would_visit) {
  EXPECT_GT(cells_to_walk(even_octree(1e-5), unit_box), most_cells_walked);
  const SpacingOctree usual = graded_octree(0.02);
  EXPECT_LT(cells_to_walk(usual, unit_box), most_cells_walked);
  EXPECT_GE(cells_to_walk(usual, unit_box), static_cast<double>(usual.leaf_count()) / 8);
}

}  // namespace
}  // namespace tetfarm
