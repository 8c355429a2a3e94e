#include "mesh/geometry/nearest_point.h"

#include <gtest/gtest.h>

#include <random>

#include "mesh/geometry/triangle_distance.h"

namespace tetfarm {
namespace {

TEST(NearestPoint, of_a_triangle_is_as_far_as_the_triangle_and_lies_in_it) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-1, 1);
  const auto point = [&] { return Vec3{place(random), place(random), place(random)}; };
  for (int i = 0; i < 1000; ++i) {
    const Vec3 a = point();
    const Vec3 b = point();
    const Vec3 c = point();
    const Vec3 p = 2.0 * point();
    const Vec3 foot = nearest_on_triangle(p, a, b, c);
    EXPECT_NEAR(norm2(foot - p), distance2_to_triangle(p, a, b, c), 1e-9);
    EXPECT_NEAR(distance2_to_triangle(foot, a, b, c), 0, 1e-18);
  }
}

TEST(NearestPoint, of_a_triangle_without_area_is_that_of_its_longest_edge) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> place(-1, 1);
  const auto point = [&] { return Vec3{place(random), place(random), place(random)}; };
  for (int i = 0; i < 1000; ++i) {
    const Vec3 a = point();
    const Vec3 b = point();
    const Vec3 p = point();
    const Vec3 foot = nearest_on_triangle(p, a, b, 0.3 * a + 0.7 * b);
    EXPECT_NEAR(distance(foot, p), distance(nearest_on_segment(p, a, b), p), 1e-12);
  }
}

TEST(NearestPoint, of_a_segment_beyond_its_end_is_the_end) {
  EXPECT_EQ(nearest_on_segment({3, 1, 0}, {0, 0, 0}, {2, 0, 0}), (Vec3{2, 0, 0}));
  EXPECT_EQ(nearest_on_segment({1, 1, 0}, {0, 0, 0}, {2, 0, 0}), (Vec3{1, 0, 0}));
  EXPECT_EQ(nearest_on_segment({1, 1, 0}, {2, 0, 0}, {2, 0, 0}), (Vec3{2, 0, 0}));
}

}  // namespace
}  // namespace tetfarm
