#include "mesh/shapes/circle_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tetfarm {
namespace {

TEST(CirclePoint, agrees_with_the_library) {
  for (const std::int64_t n : {1, 7, 8, 48, 1000}) {
    for (std::int64_t k = -n; k <= 2 * n; ++k) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
      const CirclePoint p = circle_point(k, n);
      EXPECT_NEAR(p.cosine, std::cos(angle), 4e-15);
      EXPECT_NEAR(p.sine, std::sin(angle), 4e-15);
    }
  }
}

TEST(CirclePoint, is_exact_at_the_quarters) {
  EXPECT_EQ(circle_point(0, 4).cosine, 1);
  EXPECT_EQ(circle_point(3, 12).sine, 1);
  EXPECT_EQ(circle_point(3, 12).cosine, 0);
  EXPECT_EQ(circle_point(2, 4).cosine, -1);
  EXPECT_EQ(circle_point(-1, 4).sine, -1);
}

TEST(CirclePoint, mirrors_bit_by_bit) {
  for (std::int64_t k = 1; k < 36; ++k) {
    const CirclePoint p = circle_point(k, 36);
    EXPECT_EQ(p.cosine, circle_point(36 - k, 36).cosine);
    EXPECT_EQ(p.sine, -circle_point(36 - k, 36).sine);
    EXPECT_EQ(p.cosine, -circle_point(18 - k, 36).cosine);
    EXPECT_EQ(p.sine, circle_point(9 - k, 36).cosine);
  }
}

}  // namespace
}  // namespace tetfarm
