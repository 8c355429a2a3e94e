#include "mesh/planar/smoothing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tetfarm {
namespace {

using ::testing::IsEmpty;

double worst(const TriangleComplex& complex) {
  double quality = 1;
  for (const auto& [a, b, c] : complex.triangles)
    quality =
        std::min(quality, triangle_quality(complex.point(a), complex.point(b), complex.point(c)));
  return quality;
}

TEST(Smoothing, quality_is_one_for_the_regular_triangle_and_signed) {
  const Vec2 apex{0.5, std::sqrt(0.75)};
  EXPECT_NEAR(triangle_quality({0, 0}, {1, 0}, apex), 1, 1e-15);
  EXPECT_NEAR(triangle_quality({1, 0}, {0, 0}, apex), -1, 1e-15);
  EXPECT_EQ(triangle_quality({0, 0}, {1, 0}, {2, 0}), 0);
}

TEST(Smoothing, centres_a_node_in_its_ring) {
  TriangleComplex complex = make_triangle_complex({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.9, 0.8}},
                                                  {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  EXPECT_EQ(smooth(complex, 4), 1U);
  EXPECT_NEAR(complex.points[4].x, 0.5, 1e-12);
  EXPECT_NEAR(complex.points[4].y, 0.5, 1e-12);
  EXPECT_EQ(smooth(complex, 4), 0U);
}

TEST(Smoothing, never_makes_the_worst_triangle_worse_nor_turns_one_over) {
  // A dart: the mean of the ring lies outside the kernel of the polygon.
  TriangleComplex complex =
      make_triangle_complex({{0, 0}, {10, 1}, {0.5, 1.2}, {1, 10}, {0.3, 0.3}},
                            {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  ASSERT_THAT(validate(complex), IsEmpty());
  double before = worst(complex);
  for (int sweep = 0; sweep < 10; ++sweep) {
    smooth(complex, 4);
    EXPECT_THAT(validate(complex), IsEmpty());
    EXPECT_GE(worst(complex), before);
    before = worst(complex);
  }
}

}  // namespace
}  // namespace tetfarm
