#include "mesh/spacing/surface_spacing.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

TEST(SurfaceSpacing, is_the_mean_edge_of_each_vertex) {
  SurfaceMesh one;
  one.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
  one.triangles = {{0, 1, 2}};
  const auto demands = surface_spacing(one);
  ASSERT_EQ(demands.size(), 3U);
  EXPECT_DOUBLE_EQ(demands[0].spacing, 3.5);
  EXPECT_DOUBLE_EQ(demands[1].spacing, 4);
  EXPECT_DOUBLE_EQ(demands[2].spacing, 4.5);
}

TEST(SurfaceSpacing, of_a_needle_is_near_its_length) {
  SurfaceMesh needle;
  needle.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1e-4, 0}};
  needle.triangles = {{0, 1, 2}};
  for (const PointDemand& demand : surface_spacing(needle)) EXPECT_GT(demand.spacing, 0.49);
}

TEST(SurfaceSpacing, skips_unused_vertices) {
  SurfaceMesh cube = shapes::unit_cube();
  cube.vertices.push_back({9, 9, 9});
  EXPECT_EQ(surface_spacing(cube).size(), cube.vertices.size() - 1);
}

}  // namespace
}  // namespace tetfarm
