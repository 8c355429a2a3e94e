#include "mesh/assemble/shape_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace tetfarm {
namespace {

TEST(TetShape, of_a_regular_tet_has_equal_angles_and_the_best_ratio) {
  const TetShape shape = tet_shape({1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1});
  for (const double cosine : shape.dihedral_cosines) EXPECT_NEAR(cosine, 1.0 / 3, 1e-14);
  EXPECT_NEAR(shape.min_dihedral_deg, 70.5287793655093, 1e-10);
  EXPECT_NEAR(shape.max_dihedral_deg, 70.5287793655093, 1e-10);
  EXPECT_NEAR(shape.radius_ratio, 1, 1e-14);
  EXPECT_NEAR(shape.height, 4 / std::sqrt(3), 1e-14);
  EXPECT_EQ(shape.centroid, (Vec3{0, 0, 0}));
}

TEST(TetShape, of_the_corner_of_a_cube_has_its_angles_at_the_edges_that_they_belong_to) {
  const TetShape shape = tet_shape({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  const double slope = 1 / std::sqrt(3);
  const std::array<double, 6> expected = {0, 0, 0, slope, slope, slope};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(shape.dihedral_cosines[i], expected[i], 1e-15);
    EXPECT_EQ(shape.dihedral_bins[i], i < 3 ? 9 : 5);
  }
  EXPECT_NEAR(shape.height, slope, 1e-15);
  EXPECT_EQ(shape.centroid, (Vec3{0.25, 0.25, 0.25}));
}

TEST(TetShape, of_a_flat_tet_has_no_height_and_angles_of_nothing_and_half_a_turn) {
  const TetShape shape = tet_shape({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  EXPECT_EQ(shape.min_dihedral_deg, 0);
  EXPECT_EQ(shape.max_dihedral_deg, 180);
  EXPECT_EQ(shape.radius_ratio, 0);
  EXPECT_EQ(shape.height, 0);
  const TetShape point = tet_shape({1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1});
  EXPECT_EQ(point.height, 0);
  EXPECT_EQ(point.min_dihedral_deg, 0);
}

/// Tets with heights of 0.1 to 0.5, at places of their own.
TetShape shape_with_height(double height, double x) {
  return tet_shape({x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, {x, 0, height});
}

TEST(ShapeStatistics, of_tets_that_come_later_are_as_if_added_one_by_one) {
  const std::array<double, 5> heights = {0.4, 0.2, 0.5, 0.1, 0.3};
  for (std::size_t first = 0; first <= heights.size(); ++first) {
    ShapeStatistics all;
    ShapeStatistics earlier;
    ShapeStatistics later;
    for (std::size_t i = 0; i < heights.size(); ++i) {
      const TetShape shape = shape_with_height(heights[i], static_cast<double>(i));
      all.add(shape);
      (i < first ? earlier : later).add(shape);
    }
    earlier.add(later);
    EXPECT_EQ(earlier.tets, 5);
    EXPECT_EQ(earlier.min_dihedral_deg, all.min_dihedral_deg);
    EXPECT_EQ(earlier.max_dihedral_deg, all.max_dihedral_deg);
    EXPECT_EQ(earlier.dihedral_histogram, all.dihedral_histogram);
    EXPECT_EQ(earlier.min_radius_ratio, all.min_radius_ratio);
    EXPECT_NEAR(earlier.mean_radius_ratio(), all.mean_radius_ratio(), 1e-15);
    EXPECT_EQ(earlier.smallest_height, shape_with_height(0.1, 3).height);
    EXPECT_EQ(earlier.worst_centroid, all.worst_centroid);
  }
}

TEST(ShapeStatistics, keep_the_first_of_equally_bad_tets) {
  ShapeStatistics one;
  one.add(shape_with_height(0.5, 0));
  one.add(shape_with_height(0.5, 7));
  ShapeStatistics later;
  later.add(shape_with_height(0.5, 9));
  one.add(later);
  EXPECT_EQ(one.worst_centroid, shape_with_height(0.5, 0).centroid);
}

TEST(ShapeStatistics, of_nothing_are_those_of_no_tet) {
  const ShapeStatistics none;
  EXPECT_EQ(none.mean_radius_ratio(), 0);
  EXPECT_EQ(none.smallest_height, 0);
}

TEST(ShapeStatistics, angles_are_counted_in_the_bins_that_they_fall_in) {
  std::mt19937 random(7);
  const auto number = [&random] { return static_cast<double>(random() % 1000) / 999; };
  ShapeStatistics shapes;
  std::array<std::int64_t, 18> expected{};
  double least = 180;
  double most = 0;
  for (int i = 0; i < 5000; ++i) {
    std::array<Vec3, 4> p;
    for (Vec3& v : p) v = {number(), number(), number() * (i % 3 == 0 ? 0.02 : 1)};
    if (tet_volume(p[0], p[1], p[2], p[3]) < 0) std::swap(p[2], p[3]);
    if (tet_volume(p[0], p[1], p[2], p[3]) < 1e-9) continue;
    shapes.add(p[0], p[1], p[2], p[3]);
    for (const auto& [a, b, c, d] :
         {std::array{0U, 1U, 2U, 3U}, std::array{0U, 2U, 1U, 3U}, std::array{0U, 3U, 1U, 2U},
          std::array{1U, 2U, 0U, 3U}, std::array{1U, 3U, 0U, 2U}, std::array{2U, 3U, 0U, 1U}}) {
      const Vec3 edge = normalized(p[b] - p[a]);
      const Vec3 to_c = p[c] - p[a] - dot(p[c] - p[a], edge) * edge;
      const Vec3 to_d = p[d] - p[a] - dot(p[d] - p[a], edge) * edge;
      const double angle =
          std::atan2(norm(cross(to_c, to_d)), dot(to_c, to_d)) * 180 / std::numbers::pi;
      ++expected[std::min<std::size_t>(static_cast<std::size_t>(angle / 10), 17)];
      least = std::min(least, angle);
      most = std::max(most, angle);
    }
  }
  EXPECT_EQ(shapes.dihedral_histogram, expected);
  EXPECT_NEAR(shapes.min_dihedral_deg, least, 1e-4);
  EXPECT_NEAR(shapes.max_dihedral_deg, most, 1e-4);
}

}  // namespace
}  // namespace tetfarm
