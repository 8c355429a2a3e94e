#include "mesh/render/crowded_window.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

/// Rows of nodes, `step` apart, round a place.
std::vector<Vec2> nodes(int rows, double step, const Vec2& round) {
  std::vector<Vec2> points;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows; ++j) {
      points.push_back({round.x + step * (i - rows / 2), round.y + step * (j - rows / 2)});
    }
  }
  return points;
}

TEST(CrowdedWindow, of_even_nodes_is_all_of_them) {
  EXPECT_TRUE(crowded_window(nodes(21, 0.1, {3, 4}), 1).shows_all());
}

TEST(CrowdedWindow, is_round_the_nodes_that_lie_close_together) {
  std::vector<Vec2> points = nodes(31, 0.01, {5, -2});
  for (const Vec2& far : nodes(9, 10, {0, 0})) points.push_back(far);
  const PlaneWindow window = crowded_window(points, 2);
  ASSERT_TRUE(window.across && window.centre);
  EXPECT_NEAR(window.centre->x, 5, 0.05);
  EXPECT_NEAR(window.centre->y, -2, 0.05);
  EXPECT_GT(*window.across, 2 * 0.2) << "twice as wide as high";
  EXPECT_LT(*window.across, 2 * 0.5);
}

TEST(CrowdedWindow, of_one_place_is_all_of_it) {
  EXPECT_TRUE(crowded_window(std::vector<Vec2>(5, Vec2{1, 1}), 1).shows_all());
  EXPECT_TRUE(crowded_window(std::vector<Vec2>{{1, 2}}, 1).shows_all());
}

}  // namespace
}  // namespace tetfarm
