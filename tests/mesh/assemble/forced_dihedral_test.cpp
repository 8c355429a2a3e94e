#include "mesh/assemble/forced_dihedral.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/core/tet_quality.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

/// The edge from (0, 0, 0) to (1, 0, 0) of a material of the angle, with regular triangles.
double bound_of_wedge(double angle_deg) {
  const double height = std::sqrt(0.75);
  const double angle = angle_deg * degree;
  // The material lies between y = 0, z up and the second triangle.
  const Vec3 right{0.5, height, 0};
  const Vec3 left{0.5, height * std::cos(angle), height * std::sin(angle)};
  return forced_dihedral_at_edge({0, 0, 0}, {1, 0, 0}, left, right);
}

TEST(ForcedDihedral, of_a_thin_wedge_is_that_of_the_one_tet_that_fits) {
  EXPECT_NEAR(bound_of_wedge(5), 5, 1e-9);
  EXPECT_NEAR(bound_of_wedge(30), 30, 1e-9);
}

TEST(ForcedDihedral, of_two_tets_is_half_the_angle) {
  // One tet in 120 degrees has its other angles below 60.
  EXPECT_NEAR(bound_of_wedge(120), 60, 1e-9);
}

TEST(ForcedDihedral, of_a_flat_or_hollow_edge_is_none) {
  EXPECT_GT(bound_of_wedge(180), 70.5);
  EXPECT_GT(bound_of_wedge(270), 70.5);
}

TEST(ForcedDihedral, of_a_single_tet_is_its_smallest_angle) {
  const std::vector<Vec3> nodes = {{0, 0, 0}, {1, 0, 0}, {0.4, 1, 0}, {0.3, 0.5, 0.08}};
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : tet_face_nodes) triangles.push_back({a, b, c});
  const double smallest = dihedral_range(nodes[0], nodes[1], nodes[2], nodes[3]).min_deg;
  const ForcedDihedral forced = forced_dihedral(nodes, triangles);
  EXPECT_GE(forced.at_most_deg, smallest - 1e-9);
  EXPECT_LT(forced.at_most_deg, 25);
  // The edge of the base that is farthest from the node above it.
  EXPECT_NEAR(distance(forced.at, {0.5, 0, 0}), 0, 1e-12);
}

TEST(ForcedDihedral, of_a_cube_is_no_less_than_its_tets_have) {
  const SurfaceMesh cube = shapes::unit_cube();
  const ForcedDihedral forced = forced_dihedral(cube.vertices, cube.triangles);
  EXPECT_GE(forced.at_most_deg, 45 - 1e-9);
  const SurfaceMesh sphere = shapes::sphere({0, 0, 0}, 1, 2);
  EXPECT_GT(forced_dihedral(sphere.vertices, sphere.triangles).at_most_deg, 60);
}

TEST(ForcedDihedral, leaves_out_edges_of_more_than_two_triangles) {
  const std::vector<Vec3> nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0.01}, {0, -1, 0}};
  const std::vector<Triangle> fan = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  EXPECT_GT(forced_dihedral(nodes, fan).at_most_deg, 70.5);
}

}  // namespace
}  // namespace tetfarm
