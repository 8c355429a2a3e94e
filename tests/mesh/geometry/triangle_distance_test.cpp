#include "mesh/geometry/triangle_distance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tetfarm {
namespace {

constexpr Vec3 a{0, 0, 0};
constexpr Vec3 b{4, 0, 0};
constexpr Vec3 c{0, 3, 0};

TEST(TriangleDistance, is_that_to_the_face_the_edge_or_the_corner) {
  EXPECT_DOUBLE_EQ(distance2_to_triangle({1, 1, 2}, a, b, c), 4);
  EXPECT_DOUBLE_EQ(distance2_to_triangle({2, -1, 1}, a, b, c), 2);
  EXPECT_DOUBLE_EQ(distance2_to_triangle({-3, -4, 0}, a, b, c), 25);
  // The edge from b to c has the normal (3, 4) / 5.
  EXPECT_NEAR(distance2_to_triangle({2 + 3, 1.5 + 4, 0}, a, b, c), 25, 1e-12);
}

TEST(TriangleDistance, of_a_degenerate_triangle_is_that_to_its_edges) {
  EXPECT_DOUBLE_EQ(distance2_to_triangle({1, 2, 0}, a, b, {2, 0, 0}), 4);
  EXPECT_DOUBLE_EQ(distance2_to_triangle({1, 2, 2}, a, a, a), 9);
}

TEST(TriangleDistance, is_nearer_agrees_with_the_distance) {
  int near = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p{0.013 * i - 5, 0.007 * ((i * 37) % 1000) - 3, 0.005 * ((i * 91) % 1000) - 2.5};
    const double distance = std::sqrt(distance2_to_triangle(p, a, b, c));
    EXPECT_TRUE(is_nearer_to_triangle(p, a, b, c, distance * 1.001 + 1e-12));
    EXPECT_FALSE(is_nearer_to_triangle(p, a, b, c, distance * 0.999));
    near += distance < 1 ? 1 : 0;
  }
  EXPECT_GT(near, 50);
}

}  // namespace
}  // namespace tetfarm
