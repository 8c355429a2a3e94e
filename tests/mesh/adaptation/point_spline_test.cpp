#include "mesh/adaptation/point_spline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace tetfarm {
namespace {

const std::vector<Vec2> points{{0, 0}, {0.3, 0.7}, {1.1, 1.3}, {2.9, 0.1}, {3.3, -1}};

TEST(PointSpline, points_where_its_places_go) {
  constexpr double h = 1e-6;
  for (const bool is_closed : {false, true}) {
    const PointSpline spline(points, is_closed);
    for (int i = 1; i < 60; ++i) {
      const double t = spline.length() * i / 60;
      const Vec2 direction = spline.direction(t);
      EXPECT_NEAR(direction.x, (spline.at(t + h).x - spline.at(t - h).x) / (2 * h), 1e-8) << t;
      EXPECT_NEAR(direction.y, (spline.at(t + h).y - spline.at(t - h).y) / (2 * h), 1e-8) << t;
    }
  }
}

TEST(PointSpline, finds_its_own_places_again) {
  for (const bool is_closed : {false, true}) {
    PointSpline spline(points, is_closed);
    spline.prepare_search();
    for (int i = 1; i < 200; ++i) {
      const double t = spline.length() * i / 200;
      EXPECT_NEAR(spline.nearest(spline.at(t)), t, 1e-13) << t;
    }
  }
}

TEST(PointSpline, of_a_loop_ends_where_the_loop_turns_by_more_than_the_angle) {
  const std::vector<Vec2> square{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}};
  const auto sides = splines_of_loop(square, 30);
  ASSERT_EQ(sides.size(), 4U);
  EXPECT_EQ(sides[0]->at(0), (Vec2{0, 0}));
  EXPECT_EQ(sides[0]->at(sides[0]->length()), (Vec2{2, 0}));
  EXPECT_EQ(sides[3]->at(sides[3]->length()), (Vec2{0, 0}));
  for (const auto& side : sides) EXPECT_FALSE(side->is_closed());
  const auto whole = splines_of_loop(square, 100);
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_TRUE(whole[0]->is_closed());
}

TEST(PointSpline, of_a_loop_with_one_corner_begins_and_ends_there) {
  const std::vector<Vec2> drop{{1, 0.5}, {0, 0}, {1, -0.5}, {1.4, -0.3}, {1.5, 0}, {1.4, 0.3}};
  const auto spline = splines_of_loop(drop, 100);
  ASSERT_EQ(spline.size(), 1U);
  EXPECT_EQ(spline[0]->at(0), (Vec2{0, 0}));
  EXPECT_EQ(spline[0]->at(spline[0]->length()), (Vec2{0, 0}));
}

}  // namespace
}  // namespace tetfarm
