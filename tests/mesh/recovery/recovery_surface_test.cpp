#include "mesh/recovery/recovery_surface.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

TEST(RecoverySurface, knows_its_edges_and_triangles_in_any_order_of_nodes) {
  const SurfaceMesh cube = shapes::unit_cube();
  const RecoverySurface surface(cube.triangles, 8);
  EXPECT_EQ(surface.edges().size(), 18U);
  for (std::size_t i = 0; i < cube.triangles.size(); ++i) {
    const auto& [a, b, c] = cube.triangles[i];
    EXPECT_TRUE(surface.has_edge(b, a));
    EXPECT_EQ(surface.find_triangle(c, a, b), static_cast<std::int32_t>(i));
  }
  EXPECT_FALSE(surface.has_edge(0, 100));
  EXPECT_EQ(surface.find_triangle(0, 1, 100), -1);
}

}  // namespace
}  // namespace tetfarm
