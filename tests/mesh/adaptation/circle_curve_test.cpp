#include "mesh/adaptation/circle_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace tetfarm {
namespace {

std::vector<Vec2> arc(const Circle& circle, int n, double angle, double off) {
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i) {
    const double radius = circle.radius + (i % 3 == 1 ? off : 0);
    points.push_back({circle.centre.x + radius * std::cos(angle * i / n),
                      circle.centre.y + radius * std::sin(angle * i / n)});
  }
  return points;
}

TEST(CircleCurve, goes_once_round_at_one_distance) {
  const CircleCurve circle({{3, -1}, 2});
  EXPECT_NEAR(circle.length(), 4 * std::numbers::pi, 1e-14);
  double way = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec2 p = circle.at(circle.length() * i / 1000);
    const Vec2 q = circle.at(circle.length() * (i + 1) / 1000);
    EXPECT_NEAR(std::hypot(p.x - 3, p.y + 1), 2, 1e-15);
    way += std::hypot(q.x - p.x, q.y - p.y);
    EXPECT_GT((p.x - 3) * (q.y + 1) - (p.y + 1) * (q.x - 3), 0) << i;
  }
  EXPECT_NEAR(way, circle.length(), 1e-4);
}

TEST(CircleCurve, finds_its_own_places_again) {
  const CircleCurve circle({{3, -1}, 2});
  for (int i = 0; i < 999; ++i) {
    const double t = circle.length() * (i + 0.5) / 999;
    EXPECT_NEAR(circle.nearest(circle.at(t)), t, 1e-14 * circle.length()) << i;
  }
}

TEST(CircleCurve, that_fits_nodes_on_an_arc_is_theirs) {
  const Circle wanted{{0.123456789, -3.3}, 0.7};
  const auto fitted = fitted_circle(arc(wanted, 12, 1.2, 0));
  ASSERT_TRUE(fitted.has_value());
  EXPECT_NEAR(fitted->centre.x, wanted.centre.x, 1e-13);
  EXPECT_NEAR(fitted->centre.y, wanted.centre.y, 1e-13);
  EXPECT_NEAR(fitted->radius, wanted.radius, 1e-13);
}

TEST(CircleCurve, has_round_numbers_where_nodes_leave_them_open) {
  const auto fitted = fitted_circle(arc({{0, 0}, 20}, 60, 2 * std::numbers::pi, 1e-5));
  ASSERT_TRUE(fitted.has_value());
  EXPECT_EQ(fitted->centre, (Vec2{0, 0}));
  EXPECT_EQ(fitted->radius, 20);
}

TEST(CircleCurve, does_not_fit_two_nodes_nor_a_line) {
  EXPECT_FALSE(fitted_circle(std::vector<Vec2>{{0, 0}, {1, 0}}).has_value());
  EXPECT_FALSE(fitted_circle(std::vector<Vec2>{{0, 0}, {1, 0}, {2, 0}, {5, 0}}).has_value());
}

}  // namespace
}  // namespace tetfarm
