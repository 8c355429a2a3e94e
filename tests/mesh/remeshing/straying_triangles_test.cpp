#include "mesh/remeshing/straying_triangles.h"

#include <gmock/gmock.h>

#include "mesh/remeshing/edge_collapse.h"
#include "tests/mesh/remeshing/remeshing_fixture.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;

TEST(StrayingTriangles, are_those_with_a_point_farther_off_than_the_tolerance) {
  SurfaceToChange ball(shapes::sphere({0, 0, 0}, 1, 3), 0.2, 0.1);
  EXPECT_THAT(straying_triangles(ball.work, 1e-9), IsEmpty());
  const std::int32_t v = 7;
  const std::size_t round = ball.surface.ring(v).size();
  ball.surface.move_vertex(v, 1.2 * ball.surface.at(v));
  // Half-way from the middle to the corner that was pulled out is two thirds of 0.2 off.
  EXPECT_EQ(straying_triangles(ball.work, 0.05).size(), round);
  EXPECT_THAT(straying_triangles(ball.work, 0.25), IsEmpty());
}

/// A ball made so coarse that its triangles lie up to a fiftieth of its radius inside it.
TEST(StrayingTriangles, are_divided_until_none_strays) {
  SurfaceToChange ball(shapes::sphere({0, 0, 0}, 1, 4), 0.2, 0.02);
  for (std::int32_t v = 0; v < ball.surface.vertex_end(); ++v) {
    if (ball.surface.ring(v).empty()) continue;
    const Triangle nodes = ball.surface.triangle(ball.surface.ring(v).front()).nodes;
    collapse_edge(ball.work, nodes[1], nodes[2], 100, 0.3);
  }
  const double tolerance = 0.002;
  ASSERT_FALSE(straying_triangles(ball.work, tolerance).empty());
  EXPECT_GT(split_straying_triangles(ball.work, tolerance), 0);
  EXPECT_THAT(straying_triangles(ball.work, tolerance), IsEmpty());
  EXPECT_THAT(complaints_of(ball.surface), IsEmpty());
  EXPECT_EQ(split_straying_triangles(ball.work, tolerance), 0);
}

TEST(StrayingTriangles, are_none_in_planes) {
  SurfaceToChange box(shapes::box({0, 0, 0}, {1, 1, 1}, 2), 0.2, 0.1);
  EXPECT_THAT(straying_triangles(box.work, 1e-12), IsEmpty());
}

}  // namespace
}  // namespace tetfarm
