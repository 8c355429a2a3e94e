#include "mesh/recovery/star_growth.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace tetfarm {
namespace {

/// A thin tet between the two ways to cut a square that is not quite flat, one of which is
/// constrained, with a node in it that no double has; two tets above.
struct NodeInThinTet {
  TetComplex complex = two_cuts_of_a_square();
  std::vector<std::uint8_t> marks;
  LocalRemeshing mesh{complex, marks};
  std::int32_t node = -1;

  NodeInThinTet() {
    mesh.constrain(mesh.find_face(0, 1, 2), true);
    mesh.constrain(mesh.find_face(0, 2, 3), true);
    const FinePoint low = between(mesh.fine_point(0), mesh.fine_point(2), {0.5, 0});
    const FinePoint high = between(mesh.fine_point(1), mesh.fine_point(3), {0.5, 0});
    node = mesh.add_point(between(low, high, {0.5, 0}));
    std::vector<Tet> parts(4, complex.nodes.front());
    for (std::size_t i = 0; i < 4; ++i) parts[i][i] = node;
    mesh.replace(std::array{0}, parts);
  }

  static TetComplex two_cuts_of_a_square() {
    TetMesh thin;
    thin.nodes = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, std::nextafter(1.0, 2)}, {0.4, 0.5, 2}};
    thin.tets = {{0, 1, 2, 3}, {0, 1, 3, 4}, {1, 2, 3, 4}};
    thin.boundary_nodes = 5;
    return make_tet_complex(thin);
  }
};

TEST(StarGrowth, finds_a_place_of_doubles_for_a_node_in_a_tet_as_thin_as_their_last_digit) {
  NodeInThinTet thin;
  auto& [complex, marks, mesh, node] = thin;
  ASSERT_FALSE(mesh.fine_point(node).is_plain());
  ASSERT_TRUE(grow_star(mesh, node));
  EXPECT_TRUE(mesh.fine_point(node).is_plain());
  EXPECT_GT(mesh.point(node).z, 1.01);
  EXPECT_TRUE(validate(complex).empty());
  EXPECT_NE(mesh.find_face(0, 1, 2), no_face);
  EXPECT_NE(mesh.find_face(0, 2, 3), no_face);
}

TEST(StarGrowth, changes_nothing_where_all_round_the_node_is_constrained) {
  NodeInThinTet thin;
  auto& [complex, marks, mesh, node] = thin;
  mesh.constrain(mesh.find_face(0, 1, 3), true);
  mesh.constrain(mesh.find_face(1, 2, 3), true);
  const auto before = complex.nodes;
  EXPECT_FALSE(grow_star(mesh, node));
  EXPECT_EQ(complex.nodes, before);
  EXPECT_FALSE(mesh.fine_point(node).is_plain());
}

}  // namespace
}  // namespace tetfarm
