#include "mesh/adaptation/metric_sources.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh/metric/metric_intersection.h"
#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

const Metric2 coarse = plane_test::round_metric(1);

MetricSource point_at(const Vec2& place, double along, double across, double angle_deg) {
  MetricSource source;
  source.from = source.to = place;
  source.along = along;
  source.across = across;
  source.angle_deg = angle_deg;
  source.radius = 0.5;
  return source;
}

MetricSource line_of(const Vec2& from, const Vec2& to, double along, double across) {
  MetricSource source = point_at(from, along, across, 0);
  source.to = to;
  return source;
}

/// The size in a direction.
double size_in(const Metric2& m, double angle_deg) {
  const double angle = angle_deg * std::numbers::pi / 180;
  return 1 / std::sqrt(squared_length(m, {std::cos(angle), std::sin(angle)}));
}

TEST(MetricSources, of_a_point_have_their_sizes_in_the_direction_of_the_angle) {
  for (const double angle : {0.0, 30.0, 45.0, 90.0, -120.0, 360.0}) {
    const MetricSources sources({point_at({2, 3}, 0.2, 0.01, angle)});
    for (const Vec2& place : {Vec2{2, 3}, Vec2{2.3, 3.3}, Vec2{1.6, 3}}) {
      const Metric2 m = sources.at(place, coarse);
      EXPECT_NEAR(size_in(m, angle), 0.2, 1e-9) << angle;
      EXPECT_NEAR(size_in(m, angle + 90), 0.01, 1e-11) << angle;
    }
  }
}

TEST(MetricSources, of_a_line_take_the_angle_from_the_way_it_runs) {
  MetricSource line = line_of({0, 0}, {3, 3}, 0.2, 0.01);
  const Metric2 along = MetricSources({line}).at({1.1, 1}, coarse);
  EXPECT_NEAR(size_in(along, 45), 0.2, 1e-9);
  EXPECT_NEAR(size_in(along, 135), 0.01, 1e-11);
  EXPECT_EQ(along.xx, along.yy) << "equation 10 of the thesis has no answer at 45 degrees";
  line.angle_deg = 30;
  const Metric2 turned = MetricSources({line}).at({1.1, 1}, coarse);
  EXPECT_NEAR(size_in(turned, 75), 0.2, 1e-9);
  EXPECT_NEAR(size_in(turned, 165), 0.01, 1e-11);
}

TEST(MetricSources, agree_with_equation_10_of_the_thesis_where_it_has_an_answer) {
  const double angle = 20;
  const Metric2 m = MetricSources({point_at({0, 0}, 0.2, 0.1, angle)}).at({0, 0}, coarse);
  const double cot = 1 / std::tan(2 * -angle * std::numbers::pi / 180);  // clockwise there
  EXPECT_NEAR(m.xy, (m.yy - m.xx) / (2 * cot), 1e-9);
}

TEST(MetricSources, are_constant_within_the_radius_round_all_of_the_line) {
  const MetricSources sources({line_of({0, 0}, {4, 0}, 0.2, 0.01)});
  const Metric2 on_it = sources.at({2, 0}, coarse);
  for (const Vec2& place : {Vec2{0, 0.49}, Vec2{4, -0.49}, Vec2{-0.49, 0}, Vec2{4.3, 0.3}}) {
    EXPECT_EQ(sources.at(place, coarse), on_it);
  }
  EXPECT_FALSE(sources.at({2, 0.51}, coarse) == on_it);
  EXPECT_FALSE(sources.at({4.4, 0.4}, coarse) == on_it);
}

TEST(MetricSources, grow_by_the_logarithm_of_the_growth_for_each_unit_of_metric_length) {
  MetricSource line = line_of({0, 0}, {4, 0}, 0.04, 0.01);
  line.growth = 1.3;
  const MetricSources sources({line});
  // Across the line 0.06 are six lengths; beyond its end 0.06 are one and a half.
  const Metric2 beside = sources.at({2, 0.56}, coarse);
  EXPECT_NEAR(size_in(beside, 90), 0.01 * (1 + 6 * std::log(1.3)), 1e-12);
  EXPECT_NEAR(size_in(beside, 0), 0.04 * (1 + 6 * std::log(1.3)), 1e-12);
  const Metric2 behind = sources.at({4.56, 0}, coarse);
  EXPECT_NEAR(size_in(behind, 90), 0.01 * (1 + 1.5 * std::log(1.3)), 1e-12);
}

TEST(MetricSources, never_ask_for_more_than_the_background_allows) {
  const MetricSources sources({line_of({0, 0}, {4, 0}, 3, 0.01)});
  EXPECT_NEAR(size_in(sources.at({2, 0}, coarse), 0), 1, 1e-9) << "the background's";
  EXPECT_EQ(sources.at({2, 5}, coarse), coarse);
}

TEST(MetricSources, without_growth_end_at_their_radius) {
  MetricSource source = point_at({0, 0}, 0.2, 0.01, 0);
  source.growth = 0;
  const MetricSources sources({source});
  EXPECT_NEAR(size_in(sources.at({0.4999, 0}, coarse), 90), 0.01, 1e-11);
  EXPECT_EQ(sources.at({0.5001, 0}, coarse), coarse);
  EXPECT_TRUE(sources.acts(0, {0.4999, 0}, coarse));
  EXPECT_FALSE(sources.acts(0, {0.5001, 0}, coarse));
}

TEST(MetricSources, intersect_where_they_overlap_in_their_order) {
  const MetricSource a = line_of({0, 0}, {4, 4}, 0.2, 0.01);
  const MetricSource b = line_of({0, 4}, {4, 0}, 0.2, 0.01);
  const MetricSource c = point_at({2, 2}, 0.05, 0.02, 10);
  const Metric2 crossing = MetricSources({a, b}).at({2, 2}, coarse);
  for (const double angle : {0.0, 20.0, 45.0, 135.0}) {
    EXPECT_NEAR(size_in(crossing, angle), 0.01, 1e-9) << "a circle: figure 29 of the thesis";
  }
  Metric2 expected = coarse;
  for (const MetricSource& source : {a, c, b}) {
    expected = intersection(expected, MetricSources({source}).at({2, 2}, {1e-9, 0, 1e-9}));
  }
  const Metric2 found = MetricSources({a, c, b}).at({2, 2}, coarse);
  EXPECT_NEAR(found.xx, expected.xx, 1e-9 * expected.xx);
  EXPECT_NEAR(found.xy, expected.xy, 1e-9 * expected.xx);
}

TEST(MetricSources, scale_with_a_factor_that_the_background_has_already) {
  const MetricSources sources({line_of({0, 0}, {4, 0}, 0.2, 0.01)});
  for (const Vec2& place : {Vec2{2, 0}, Vec2{2, 0.6}, Vec2{2, 3}}) {
    const Metric2 plain = sources.at(place, coarse);
    const Metric2 scaled = sources.at(place, 0.9 * coarse, 0.9);
    EXPECT_NEAR(scaled.xx, 0.9 * plain.xx, 1e-12 * plain.xx);
    EXPECT_NEAR(scaled.yy, 0.9 * plain.yy, 1e-12 * plain.yy);
  }
}

TEST(MetricSources, that_are_noticeable_make_any_long_edge_beside_them_long) {
  MetricSource source = point_at({0, 0}, 2e-4, 1e-4, 30);
  source.radius = 1e-4;
  source.growth = 0;
  EXPECT_FALSE(MetricSources({source}).is_noticeable());
  const MetricSources slow = MetricSources({source}).noticeable();
  EXPECT_TRUE(slow.is_noticeable());
  const Metric2 far_coarser{1e-6, 0, 1e-6};
  for (double half = 1e-3; half < 100; half *= 3) {
    for (const double angle : {0.0, 30.0, 120.0}) {
      const double x = half * std::cos(angle);
      const double y = half * std::sin(angle);
      EXPECT_GT(length_between({2 * x, 2 * y}, slow.at({-x, -y}, far_coarser),
                               slow.at({x, y}, far_coarser)),
                2)
          << half;
    }
  }
}

}  // namespace
}  // namespace tetfarm
