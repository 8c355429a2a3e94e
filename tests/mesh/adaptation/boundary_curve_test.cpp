#include "mesh/adaptation/boundary_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace tetfarm {
namespace {

std::vector<Vec2> circle_points(int n) {
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  return points;
}

double distance_between(const Vec2& a, const Vec2& b) { return std::hypot(b.x - a.x, b.y - a.y); }

TEST(BoundaryCurve, keeps_the_common_coordinate_of_a_straight_line_bit_by_bit) {
  const BoundaryCurve level({{0, 0.3}, {0.1, 0.3}, {1.0 / 3, 0.3}, {1, 0.3}}, false);
  const BoundaryCurve upright({{-0.7, 2}, {-0.7, 1.1}, {-0.7, 1.0 / 3}, {-0.7, 0}}, false);
  for (int i = 0; i <= 100; ++i) {
    EXPECT_EQ(level.at(level.length() * i / 100).y, 0.3);
    EXPECT_EQ(upright.at(upright.length() * i / 100).x, -0.7);
  }
  EXPECT_NEAR(level.at(0.25).x, 0.25, 1e-15);
  EXPECT_NEAR(upright.at(0.5).y, 1.5, 1e-15);
}

TEST(BoundaryCurve, hits_both_ends_of_an_oblique_line_bit_by_bit) {
  const Vec2 a{0.1, 0.7};
  const Vec2 b{1.0 / 3, -2.0 / 7};
  const BoundaryCurve line({a, {(a.x + b.x) / 2, (a.y + b.y) / 2}, b}, false);
  EXPECT_EQ(line.at(0), a);
  EXPECT_EQ(line.at(line.length()), b);
  EXPECT_EQ(line.at(-1), a);
  EXPECT_EQ(line.at(line.length() + 1), b);
  EXPECT_LE(distance_between(line.at(line.parameter_of(1)), {(a.x + b.x) / 2, (a.y + b.y) / 2}),
            1e-15);
}

TEST(BoundaryCurve, gives_its_points_at_their_parameters_bit_by_bit) {
  const std::vector<Vec2> points{{0, 0}, {0.3, 0.7}, {1.1, 1.3}, {2.9, 0.1}, {3.3, -1}};
  for (const bool is_closed : {false, true}) {
    const BoundaryCurve curve(points, is_closed);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(curve.at(curve.parameter_of(i)), points[i]) << i << is_closed;
    }
    EXPECT_EQ(curve.at(curve.length()), is_closed ? points.front() : points.back());
    EXPECT_EQ(curve.at(0), points.front());
  }
}

TEST(BoundaryCurve, measures_its_length_by_chords) {
  const BoundaryCurve open({{0, 0}, {3, 4}, {3, 5}}, false);
  EXPECT_DOUBLE_EQ(open.parameter_of(1), 5);
  EXPECT_DOUBLE_EQ(open.length(), 6);
  const BoundaryCurve closed({{0, 0}, {3, 4}, {3, 0}}, true);
  EXPECT_DOUBLE_EQ(closed.length(), 12);
}

TEST(BoundaryCurve, is_within_a_thousandth_of_the_circle_of_sixteen_points) {
  const BoundaryCurve circle(circle_points(16), true);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 p = circle.at(circle.length() * i / 1000);
    EXPECT_NEAR(std::hypot(p.x, p.y), 1, 1e-3) << i;
    EXPECT_LE(distance_between(
                  p, {std::cos(std::numbers::pi * i / 500), std::sin(std::numbers::pi * i / 500)}),
              1e-3);
  }
}

TEST(BoundaryCurve, converges_with_the_fourth_power_to_a_circle) {
  const auto error_of = [](int n) {
    const BoundaryCurve circle(circle_points(n), true);
    const Vec2 p = circle.at(circle.length() / (2 * n));
    return std::abs(std::hypot(p.x, p.y) - 1);
  };
  EXPECT_GT(error_of(16) / error_of(32), 14);
  EXPECT_GT(error_of(32) / error_of(64), 14);
}

TEST(BoundaryCurve, bends_alike_in_all_pieces_of_a_regular_polygon) {
  const BoundaryCurve curve(circle_points(5), true);
  const Vec2 first = curve.at(curve.length() * 0.1);
  for (int i = 1; i < 5; ++i) {
    const Vec2 p = curve.at(curve.length() * (0.1 + 0.2 * i));
    EXPECT_NEAR(std::hypot(p.x, p.y), std::hypot(first.x, first.y), 1e-14) << i;
  }
}

TEST(BoundaryCurve, goes_round_and_round_when_closed) {
  const BoundaryCurve curve({{0, 0}, {2, 0.1}, {2.5, 1}, {0.2, 1.4}}, true);
  for (int i = 0; i < 50; ++i) {
    const double s = curve.length() * i / 50;
    EXPECT_LE(distance_between(curve.at(s + curve.length()), curve.at(s)), 1e-14);
    EXPECT_LE(distance_between(curve.at(s - 3 * curve.length()), curve.at(s)), 1e-14);
  }
}

TEST(BoundaryCurve, has_no_kink_where_it_closes) {
  const BoundaryCurve curve({{0, 0}, {2, 0.1}, {2.5, 1}, {0.2, 1.4}}, true);
  constexpr double h = 1e-6;
  const Vec2 before = curve.at(-h);
  const Vec2 here = curve.at(0);
  const Vec2 after = curve.at(h);
  EXPECT_NEAR((after.x - here.x) / h, (here.x - before.x) / h, 1e-4);
  EXPECT_NEAR((after.y - here.y) / h, (here.y - before.y) / h, 1e-4);
}

TEST(BoundaryCurve, is_the_natural_spline_when_open) {
  const BoundaryCurve curve({{0, 0}, {1, 1}, {2, 0}}, false);
  // The second derivative is 0 at both ends and -3/2 in the middle.
  const Vec2 p = curve.at(curve.length() / 4);
  EXPECT_NEAR(p.x, 0.5, 1e-15);
  EXPECT_NEAR(p.y, 0.6875, 1e-15);
  const Vec2 q = curve.at(curve.length() * 3 / 4);
  EXPECT_NEAR(q.x, 1.5, 1e-15);
  EXPECT_NEAR(q.y, 0.6875, 1e-15);
}

TEST(BoundaryCurve, that_ends_where_it_began_is_no_line) {
  // A border with one corner.
  const std::vector<Vec2> points{{0, 0}, {1, -0.5}, {2, 0}, {1, 0.5}, {0, 0}};
  const BoundaryCurve drop(points, false);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(drop.at(drop.parameter_of(i)), points[i]) << i;
  }
}

TEST(BoundaryCurve, that_turns_back_on_a_line_is_no_line) {
  const BoundaryCurve curve({{0, 0}, {2, 0}, {1, 0}}, false);
  EXPECT_EQ(curve.at(2), (Vec2{2, 0}));
}

TEST(BoundaryCurve, way_has_a_sign_and_is_the_shorter_one_when_closed) {
  const BoundaryCurve open({{0, 0}, {1, 0}, {1, 9}}, false);
  EXPECT_EQ(open.way(1, 9), 8);
  EXPECT_EQ(open.way(9, 1), -8);
  const BoundaryCurve closed({{0, 0}, {4, 0}, {4, 3}}, true);
  ASSERT_EQ(closed.length(), 12);
  EXPECT_EQ(closed.way(1, 3), 2);
  EXPECT_EQ(closed.way(3, 1), -2);
  EXPECT_EQ(closed.way(1, 11), -2);
  EXPECT_EQ(closed.way(11, 1), 2);
  EXPECT_EQ(closed.way(0, 12), 0);
}

}  // namespace
}  // namespace tetfarm
