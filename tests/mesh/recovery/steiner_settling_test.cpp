#include "mesh/recovery/steiner_settling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "mesh/geometry/bowyer_watson.h"
#include "mesh/recovery/boundary_recovery.h"
#include "tests/mesh/volume/volume_checks.h"

namespace tetfarm {
namespace {

/// Four tets round node 4, with the fourth of the others at that height.
TetMesh four_round_a_node(double height) {
  TetMesh mesh;
  mesh.nodes = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, height}, {1, 1, height / 4}};
  mesh.tets = {{0, 1, 2, 4}, {0, 3, 1, 4}, {1, 3, 2, 4}, {2, 3, 0, 4}};
  return mesh;
}

TEST(SteinerSettling, makes_one_tet_of_four) {
  TetComplex complex = make_tet_complex(four_round_a_node(3));
  std::vector<std::uint8_t> marks(4, 0);
  LocalRemeshing mesh(complex, marks);
  EXPECT_TRUE(remove_node(mesh, 4));
  EXPECT_TRUE(validate(complex).empty());
  EXPECT_LT(complex.node2tet[4], 0);
}

TEST(SteinerSettling, makes_no_flat_tet_of_four_that_are_flat_at_a_split_point) {
  TetComplex complex = make_tet_complex(four_round_a_node(0));
  std::vector<std::uint8_t> marks(4, 0);
  LocalRemeshing mesh(complex, marks);
  const auto before = complex.nodes;
  EXPECT_FALSE(remove_node(mesh, 4));
  EXPECT_EQ(complex.nodes, before);
}

TEST(SteinerSettling, changes_nothing_round_a_node_that_stays) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(0, 1);
  std::vector<Vec3> points(40);
  for (Vec3& p : points) p = {place(random), place(random), place(random)};
  const TetComplex before = bowyer_watson(points).complex;
  int stayed = 0;
  for (std::int32_t v = 0; v < 40; ++v) {
    TetComplex complex = before;
    std::vector<std::uint8_t> constrained(complex.nodes.size(), 0);
    LocalRemeshing mesh(complex, constrained);
    if (remove_node(mesh, v)) continue;
    ++stayed;
    EXPECT_EQ(complex.nodes, before.nodes);
    EXPECT_EQ(complex.neighbours, before.neighbours);
  }
  EXPECT_GT(stayed, 0);
}

TEST(SteinerSettling, takes_nodes_out_of_random_tets_by_flips_and_leaves_them_valid) {
  std::mt19937_64 random(5);
  std::vector<Vec3> points(60);
  for (Vec3& p : points) {
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = std::uniform_real_distribution<double>(0, 1)(random);
    }
  }
  TetComplex complex = bowyer_watson(points).complex;
  std::vector<std::uint8_t> marks;
  LocalRemeshing mesh(complex, marks);
  int removed = 0;
  for (std::int32_t v = 0; v < 40; ++v) {
    const auto before = complex.nodes;
    if (!remove_node(mesh, v)) {
      EXPECT_EQ(complex.nodes, before);
      continue;
    }
    ++removed;
    ASSERT_TRUE(validate(complex).empty());
    for (const Tet& t : complex.nodes) EXPECT_EQ(std::count(t.begin(), t.end(), v), 0);
  }
  EXPECT_GT(removed, 30);
}

TEST(SteinerSettling, keeps_the_point_that_schoenhardts_polyhedron_needs_on_plain_doubles) {
  const Subdomain domain = root_subdomain(shapes::schoenhardt());
  TetComplex complex = bowyer_watson(domain.vertices).complex;
  std::vector<std::uint8_t> marks(complex.nodes.size(), 0);
  const RecoveredBoundary recovered = recover_boundary(complex, marks, domain.triangles);
  EXPECT_TRUE(recovered.lost.empty());
  EXPECT_EQ(recovered.steiner_points, 1);
}

}  // namespace
}  // namespace tetfarm
