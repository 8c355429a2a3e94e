// The triangulator of the generated surfaces.
#include "tests/support/ear_clipping.h"

#include <gtest/gtest.h>

#include <map>

namespace tetfarm::shapes {
namespace {

/// Positive triangles whose edges cancel but for the sides of the loops cover the polygon once.
void expect_triangulation(const std::vector<Loop>& loops, EarOrder order) {
  std::vector<GridPoint> points;
  std::map<std::array<std::int32_t, 2>, int> uses;
  for (const Loop& loop : loops) {
    const auto first = static_cast<std::int32_t>(points.size());
    const auto n = static_cast<std::int32_t>(loop.size());
    for (std::int32_t k = 0; k < n; ++k) {
      --uses[{first + k, first + (k + 1) % n}];
      ++uses[{first + (k + 1) % n, first + k}];
    }
    points.insert(points.end(), loop.begin(), loop.end());
  }
  const auto triangles = clip_ears(loops, order);
  EXPECT_EQ(triangles.size(), points.size() + 2 * loops.size() - 4);
  for (const auto& t : triangles) {
    const auto p = [&](std::size_t k) { return points[static_cast<std::size_t>(t[k])]; };
    EXPECT_GT(turn(p(0), p(1), p(2)), 0);
    for (std::size_t k = 0; k < 3; ++k) {
      ++uses[{t[k], t[(k + 1) % 3]}];
      --uses[{t[(k + 1) % 3], t[k]}];
    }
  }
  for (const auto& [edge, count] : uses) EXPECT_EQ(count, 0) << edge[0] << " " << edge[1];
}

void expect_triangulations(const std::vector<Loop>& loops) {
  expect_triangulation(loops, EarOrder::lowest);
  expect_triangulation(loops, EarOrder::next);
}

TEST(EarClipping, keeps_corners_within_straight_sides) {
  expect_triangulations({{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 2}, {0, 1}}});
  expect_triangulations({{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 3}}});
}

TEST(EarClipping, bridges_holes_whose_corners_lie_on_common_lines) {
  std::vector<Loop> loops = {rectangle({0, 0}, {50, 50})};
  for (std::int64_t x = 0; x < 5; ++x) {
    for (std::int64_t y = 0; y < 5; ++y) {
      loops.push_back(reversed(moved(rectangle({0, 0}, {4, 4}), {10 * x + 3, 10 * y + 3})));
    }
  }
  expect_triangulations(loops);
}

TEST(EarClipping, covers_stars_with_star_shaped_holes) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Chance chance(seed);
    std::vector<Loop> loops = {
        moved(star_loop(chance.pick(3, 40), 1200, 2000, chance), {250, 250})};
    for (std::int64_t k = chance.pick(0, 3); k >= 0; --k) {
      const Loop hole = star_loop(chance.pick(3, 12), 50, 115, chance);
      loops.push_back(reversed(moved(hole, {135 + 230 * (k % 2), 135 + 230 * (k / 2)})));
    }
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_triangulations(loops);
  }
}

}  // namespace
}  // namespace tetfarm::shapes
