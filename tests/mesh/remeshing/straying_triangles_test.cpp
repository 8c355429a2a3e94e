#include "mesh/remeshing/straying_triangles.h"

#include <gmock/gmock.h>

#include "tests/mesh/remeshing/remeshing_fixture.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

TEST(StrayingTriangles, are_those_with_a_point_farther_off_than_the_tolerance) {
  SurfaceToChange ball(shapes::sphere({0, 0, 0}, 1, 3), 0.2, 0.1);
  EXPECT_EQ(straying_triangles(ball.work, 1e-9), 0);
  const std::int32_t v = 7;
  const auto round = static_cast<std::int64_t>(ball.surface.ring(v).size());
  ball.surface.move_vertex(v, 1.2 * ball.surface.at(v));
  // Half-way from the middle to the corner that was pulled out is two thirds of 0.2 off.
  EXPECT_EQ(straying_triangles(ball.work, 0.05), round);
  EXPECT_EQ(straying_triangles(ball.work, 0.25), 0);
}

TEST(StrayingTriangles, are_none_in_planes) {
  SurfaceToChange box(shapes::box({0, 0, 0}, {1, 1, 1}, 2), 0.2, 0.1);
  EXPECT_EQ(straying_triangles(box.work, 1e-12), 0);
}

}  // namespace
}  // namespace tetfarm
