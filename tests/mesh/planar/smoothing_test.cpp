#include "mesh/planar/smoothing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

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

TEST(Smoothing, never_makes_the_worst_triangle_of_a_random_ring_worse) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    const std::int32_t n = 3 + round % 8;
    std::vector<Vec2> points;
    std::vector<TriangleComplex::Nodes> triangles;
    for (std::int32_t i = 0; i < n; ++i) {
      const double radius = 0.2 + static_cast<double>(random()) / 4294967296.0;
      const double angle = 2 * std::numbers::pi * i / n;
      points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
      triangles.push_back({i, (i + 1) % n, n});
    }
    points.push_back({0, 0});
    TriangleComplex complex = make_triangle_complex(points, triangles);
    const double before = worst(complex);
    smooth(complex, n);
    EXPECT_GE(worst(complex), before);
    EXPECT_THAT(validate(complex), IsEmpty());
  }
}

}  // namespace
}  // namespace tetfarm
