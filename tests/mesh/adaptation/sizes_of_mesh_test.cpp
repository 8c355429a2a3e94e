#include "mesh/adaptation/sizes_of_mesh.h"

#include <gtest/gtest.h>

#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

TEST(SizesOfMesh, are_the_mean_lengths_of_the_edges_of_each_node) {
  PlaneMesh mesh;
  mesh.points = {{0, 0}, {3, 0}, {0, 4}, {9, 9}};
  mesh.triangles = {{0, 1, 2}};
  const std::vector<Metric2> sizes = sizes_of_mesh(checked_complex(mesh));
  ASSERT_EQ(sizes.size(), 4U);
  const std::vector<double> expected{3.5, 4, 4.5, 1};
  for (std::size_t v = 0; v < 4; ++v) {
    EXPECT_NEAR(sizes[v].xx, 1 / (expected[v] * expected[v]), 1e-15) << v;
    EXPECT_EQ(sizes[v].xx, sizes[v].yy);
    EXPECT_NEAR(sizes[v].xy, 0, 1e-18);
  }
}

}  // namespace
}  // namespace tetfarm
