#include "mesh/assemble/mesh_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tetfarm {
namespace {

/// A row of unit cubes along x, six tets each.
struct Row {
  explicit Row(int cubes) {
    for (int x = 0; x <= cubes; ++x) {
      for (int i = 0; i < 4; ++i) {
        nodes.push_back(
            {static_cast<double>(x), static_cast<double>(i / 2), static_cast<double>(i % 2)});
      }
    }
    for (std::int32_t x = 0; x < cubes; ++x) {
      std::array<std::int32_t, 3> steps = {1, 2, 4};
      do {
        const std::int32_t a = 4 * x;
        Tet tet = {a, a + steps[0], a + steps[0] + steps[1], a + 7};
        const auto p = [&](std::size_t i) { return nodes[static_cast<std::size_t>(tet[i])]; };
        if (tet_volume(p(0), p(1), p(2), p(3)) < 0) std::swap(tet[1], tet[2]);
        tets.push_back(tet);
      } while (std::next_permutation(steps.begin(), steps.end()));
    }
  }
  std::vector<bool> nodes_at(double x) const {
    std::vector<bool> result;
    for (const Vec3& p : nodes) result.push_back(p.x == x);
    return result;
  }
  std::vector<Vec3> nodes;
  std::vector<Tet> tets;
};

TEST(MeshShapes, near_a_cut_are_three_layers_on_either_side) {
  const Row row(10);
  MeshShapes shapes;
  add_shapes(row.nodes, row.tets, 1, row.nodes_at(5), shapes);
  EXPECT_EQ(shapes.near_cuts.tets, 6 * 6);
  EXPECT_EQ(shapes.away_from_cuts.tets, 4 * 6);
  EXPECT_EQ(shapes.all.tets, 60);
}

TEST(MeshShapes, of_a_mesh_without_cuts_are_all_away_from_them) {
  const Row row(3);
  MeshShapes shapes;
  add_shapes(row.nodes, row.tets, 1, std::vector<bool>(row.nodes.size(), false), shapes);
  EXPECT_EQ(shapes.near_cuts.tets, 0);
  EXPECT_EQ(shapes.near_cuts.smallest_height, 0);
  EXPECT_EQ(shapes.away_from_cuts.tets, 18);
  EXPECT_NEAR(shapes.all.smallest_height, 1 / std::sqrt(2), 1e-15);
  EXPECT_NEAR(shapes.all.min_dihedral_deg, 45, 1e-9);
}

TEST(MeshShapes, of_a_bad_tet_count_where_it_lies) {
  Row row(10);
  row.nodes[4 * 5].x = 5.9;  // in cubes 4 and 5
  MeshShapes shapes;
  add_shapes(row.nodes, row.tets, 1, row.nodes_at(0), shapes);
  EXPECT_NEAR(shapes.near_cuts.min_dihedral_deg, 45, 1e-9);
  EXPECT_LT(shapes.away_from_cuts.min_dihedral_deg, 20);
  EXPECT_EQ(shapes.all.min_dihedral_deg, shapes.away_from_cuts.min_dihedral_deg);
  EXPECT_EQ(shapes.all.smallest_height, shapes.away_from_cuts.smallest_height);
}

TEST(MeshShapes, are_kept_for_each_region) {
  const Row row(2);
  MeshShapes shapes;
  const std::vector<bool> none(row.nodes.size(), false);
  add_shapes(row.nodes, std::span(row.tets).first(6), 2, none, shapes);
  add_shapes(row.nodes, std::span(row.tets).last(6), 1, none, shapes);
  ASSERT_EQ(shapes.regions.size(), 2U);
  for (const RegionShapes& region : shapes.regions) {
    EXPECT_EQ(region.shapes.tets, 6);
    EXPECT_NEAR(region.volume, 1, 1e-14);
  }
}

}  // namespace
}  // namespace tetfarm
