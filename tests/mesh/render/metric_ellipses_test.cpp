#include "mesh/render/metric_ellipses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tetfarm {
namespace {

TEST(MetricEllipses, have_metric_length_1_all_round_and_the_sizes_as_axes) {
  for (const double angle : {0.0, 0.4, 0.785398163397448, 2.5}) {
    const Metric2 metric = metric_of_sizes({0.5, 0.02, angle});
    double longest = 0;
    double shortest = 1e9;
    for (const Vec2& p : ellipse_points(unit_ellipse(metric), 1200)) {
      EXPECT_NEAR(squared_length(metric, p), 1, 1e-9);
      const double length = std::sqrt(p.x * p.x + p.y * p.y);
      longest = std::max(longest, length);
      shortest = std::min(shortest, length);
    }
    EXPECT_NEAR(longest, 0.5, 0.5e-4);
    EXPECT_NEAR(shortest, 0.02, 0.02e-2);
  }
}

TEST(MetricEllipses, are_apart_where_a_line_parts_them) {
  const Metric2 flat = metric_of_sizes({1, 0.1, 0});
  EXPECT_TRUE(are_apart({0, 0}, flat, {0, 0.25}, flat, 0.04));
  EXPECT_FALSE(are_apart({0, 0}, flat, {0, 0.25}, flat, 0.06));
  EXPECT_FALSE(are_apart({0, 0}, flat, {1.9, 0}, flat, 0));
  EXPECT_TRUE(are_apart({0, 0}, flat, {2.1, 0}, flat, 0.05));
  EXPECT_FALSE(are_apart({0, 0}, flat, {0, 0}, flat, 0));
}

struct Scattered {
  std::vector<Vec2> points;
  std::vector<Metric2> metrics;
};

/// Nodes on a grid with stretched metrics that turn and grow.
Scattered scattered() {
  Scattered all;
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 40; ++j) {
      all.points.push_back({0.025 * i, 0.025 * j});
      const double size = 0.02 + 0.002 * i;
      all.metrics.push_back(metric_of_sizes({size, 0.3 * size, 0.1 * j}));
    }
  }
  return all;
}

bool overlap(const Scattered& all, std::size_t a, std::size_t b) {
  for (const Vec2& p : ellipse_points(unit_ellipse(all.metrics[a]), 64)) {
    const Vec2 from_b{all.points[a].x + p.x - all.points[b].x,
                      all.points[a].y + p.y - all.points[b].y};
    if (squared_length(all.metrics[b], from_b) < 1) return true;
  }
  return false;
}

TEST(MetricEllipses, that_are_chosen_do_not_overlap_and_leave_no_room_for_more) {
  const Scattered all = scattered();
  const EllipseChoice choice{{0, 0}, {1, 1}, 0.002, 0};
  const std::vector<std::int32_t> chosen = spaced_ellipses(all.points, all.metrics, choice);
  EXPECT_GT(chosen.size(), 50U);
  for (const std::int32_t a : chosen) {
    for (const std::int32_t b : chosen) {
      if (a != b) {
        EXPECT_FALSE(overlap(all, static_cast<std::size_t>(a), static_cast<std::size_t>(b)));
      }
    }
  }
  for (std::size_t v = 0; v < all.points.size(); ++v) {
    EXPECT_TRUE(std::any_of(chosen.begin(), chosen.end(), [&](std::int32_t c) {
      const auto i = static_cast<std::size_t>(c);
      return !are_apart(all.points[v], all.metrics[v], all.points[i], all.metrics[i],
                        choice.distance);
    })) << v;
  }
  EXPECT_EQ(spaced_ellipses(all.points, all.metrics, choice), chosen);
}

TEST(MetricEllipses, are_chosen_within_the_window_and_large_enough_to_be_seen) {
  const Scattered all = scattered();
  const EllipseChoice choice{{0.2, 0.3}, {0.5, 0.6}, 0.001, 0.06};
  const std::vector<std::int32_t> chosen = spaced_ellipses(all.points, all.metrics, choice);
  EXPECT_FALSE(chosen.empty());
  for (const std::int32_t v : chosen) {
    const Vec2& p = all.points[static_cast<std::size_t>(v)];
    EXPECT_TRUE(p.x >= 0.2 && p.x <= 0.5 && p.y >= 0.3 && p.y <= 0.6);
    EXPECT_GT(p.x / 0.025 * 0.004 + 0.04, 0.06 - 1e-12) << "twice its longer size";
  }
}

}  // namespace
}  // namespace tetfarm
