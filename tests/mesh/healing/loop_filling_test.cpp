#include "mesh/healing/loop_filling.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetfarm {
namespace {

using ::testing::SizeIs;

bool is_free(std::int32_t, std::int32_t) { return false; }

double area_of(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles) {
  double area = 0;
  for (const Triangle& t : triangles) {
    const auto at = [&](std::size_t k) { return vertices[static_cast<std::size_t>(t[k])]; };
    area += 0.5 * norm(cross(at(1) - at(0), at(2) - at(0)));
  }
  return area;
}

std::vector<std::int32_t> numbers_to(std::size_t count) {
  std::vector<std::int32_t> loop(count);
  std::iota(loop.begin(), loop.end(), 0);
  return loop;
}

TEST(LoopFilling, has_the_area_of_a_plane_loop_that_is_not_convex) {
  // An L of three squares.
  const std::vector<Vec3> l = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  const auto made = fill_loop(l, numbers_to(6), is_free);
  ASSERT_TRUE(made.has_value());
  EXPECT_THAT(*made, SizeIs(4));
  EXPECT_NEAR(area_of(l, *made), 3, 1e-12);
  for (const Triangle& t : *made) EXPECT_LT(t[0], t[1]) << "in the direction of the loop";
}

TEST(LoopFilling, is_the_least_of_a_bent_loop) {
  // A square bent along one diagonal: along that the area is least.
  const std::vector<Vec3> bent = {{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}};
  const auto made = fill_loop(bent, numbers_to(4), is_free);
  ASSERT_TRUE(made.has_value());
  EXPECT_NEAR(area_of(bent, *made), std::sqrt(3), 1e-12);
}

TEST(LoopFilling, makes_no_edge_that_is_taken) {
  const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto without = [&square](std::int32_t x, std::int32_t y) {
    const auto made = fill_loop(square, numbers_to(4), [=](std::int32_t a, std::int32_t b) {
      return std::min(a, b) == x && std::max(a, b) == y;
    });
    return made ? *made : std::vector<Triangle>{};
  };
  const std::vector<Triangle> by_the_other = without(0, 2);
  EXPECT_THAT(by_the_other, SizeIs(2));
  EXPECT_THAT(by_the_other, ::testing::Each(::testing::IsSupersetOf({1, 3})));
  const std::vector<Triangle> by_the_first = without(1, 3);
  EXPECT_THAT(by_the_first, SizeIs(2));
  EXPECT_THAT(by_the_first, ::testing::Each(::testing::IsSupersetOf({0, 2})));
  EXPECT_FALSE(fill_loop(square, numbers_to(4), [](std::int32_t, std::int32_t) { return true; }));
}

TEST(LoopFilling, makes_no_triangle_without_area) {
  const std::vector<Vec3> on_side = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}};
  const auto made = fill_loop(on_side, numbers_to(4), is_free);
  ASSERT_TRUE(made.has_value());
  for (const Triangle& t : *made) EXPECT_THAT(t, ::testing::IsSupersetOf({1, 3}));
  const std::vector<Vec3> line = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  EXPECT_FALSE(fill_loop(line, numbers_to(3), is_free));
}

TEST(LoopFilling, is_not_tried_for_long_loops) {
  std::vector<Vec3> circle;
  for (std::size_t i = 0; i < longest_loop + 1; ++i) {
    const auto share = static_cast<double>(i) / static_cast<double>(longest_loop + 1);
    circle.push_back({std::cos(6.28 * share), std::sin(6.28 * share), 0});
  }
  EXPECT_FALSE(fill_loop(circle, numbers_to(longest_loop + 1), is_free));
  EXPECT_TRUE(fill_loop(circle, numbers_to(longest_loop), is_free));
}

}  // namespace
}  // namespace tetfarm
