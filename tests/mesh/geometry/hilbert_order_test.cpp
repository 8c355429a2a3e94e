#include "mesh/geometry/hilbert_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace tetfarm {
namespace {

std::vector<Vec3> grid(int n) {
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) points.push_back({i + 0.5, j + 0.5, k + 0.5});
    }
  }
  return points;
}

TEST(HilbertOrder, steps_along_the_curve_go_to_the_next_cell_of_a_grid) {
  std::vector<Vec3> points = grid(8);
  points.push_back({0, 0, 0});
  points.push_back({8, 8, 8});
  const auto order = hilbert_order(points);
  const auto is_cell = [](std::int32_t i) { return i < 512; };
  std::vector<std::int32_t> cells;
  std::copy_if(order.begin(), order.end(), std::back_inserter(cells), is_cell);
  for (std::size_t i = 1; i < cells.size(); ++i) {
    EXPECT_DOUBLE_EQ(distance(points[static_cast<std::size_t>(cells[i - 1])],
                              points[static_cast<std::size_t>(cells[i])]),
                     1.0);
  }
}

TEST(HilbertOrder, of_places_that_are_no_list_is_that_of_the_list) {
  for (const int n : {0, 1, 5}) {
    const std::vector<Vec3> points = grid(n);
    EXPECT_EQ(hilbert_order(points.size(), [&](std::size_t i) { return points[i]; }),
              hilbert_order(points));
  }
}

TEST(HilbertOrder, the_order_is_that_of_the_indices) {
  std::vector<Vec3> points = grid(6);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] *= 1.0 + 1e-3 * double(i * i % 97);
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  const auto index = [&](std::int32_t i) {
    return hilbert_index(points[static_cast<std::size_t>(i)], box);
  };
  const auto order = hilbert_order(points);
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end(), [&](std::int32_t i, std::int32_t j) {
    return index(i) != index(j) ? index(i) < index(j) : i < j;
  }));
}

TEST(HilbertOrder, orders_are_permutations) {
  const std::vector<Vec3> points = grid(15);
  for (auto order : {hilbert_order(points), brio_order(points)}) {
    std::sort(order.begin(), order.end());
    std::vector<std::int32_t> all(points.size());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(order, all);
  }
}

TEST(HilbertOrder, equal_points_and_a_single_point_are_ordered_by_number) {
  const std::vector<Vec3> points(4, Vec3{1, 2, 3});
  EXPECT_EQ(hilbert_order(points), (std::vector<std::int32_t>{0, 1, 2, 3}));
  EXPECT_TRUE(brio_order({}).empty());
}

TEST(HilbertOrder, the_first_rounds_of_brio_are_a_small_share_spread_over_the_box) {
  const std::vector<Vec3> points = grid(30);
  const auto order = brio_order(points);
  Box3 box;
  for (std::size_t i = 0; i < 1000; ++i) box.add(points[static_cast<std::size_t>(order[i])]);
  EXPECT_GT(box.size().x, 25);
  EXPECT_GT(box.size().y, 25);
  EXPECT_GT(box.size().z, 25);
}

}  // namespace
}  // namespace tetfarm
