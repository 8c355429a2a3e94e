#include "mesh/arrangement/exact_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tetfarm {
namespace {

TEST(ExactPoints, a_crossing_lies_exactly_in_the_plane_and_on_the_line) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto vec = [&] { return Vec3{any(random), any(random) * 1e-3, any(random) * 1e5}; };
  for (int i = 0; i < 100; ++i) {
    const std::array<Vec3, 3> plane = {vec(), vec(), vec()};
    const Vec3 p = vec();
    const Vec3 q = vec();
    const ExactPoint x = plane_crossing(p, q, plane);
    std::array<ExactPoint, 3> c = {exact_point(plane[0]), exact_point(plane[1]),
                                   exact_point(plane[2])};
    // Four points of a plane: the volume between them, in fractions.
    mpq_class volume;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t u = (k + 1) % 3;
      const std::size_t v = (k + 2) % 3;
      volume += (x.at[k] - c[0].at[k]) * ((c[1].at[u] - c[0].at[u]) * (c[2].at[v] - c[0].at[v]) -
                                          (c[1].at[v] - c[0].at[v]) * (c[2].at[u] - c[0].at[u]));
    }
    EXPECT_EQ(volume, 0);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(seen_area(exact_point(p), exact_point(q), x, axis), 0);
      EXPECT_EQ(seen_turn(exact_point(p), exact_point(q), x, axis), 0);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(x.near[static_cast<int>(k)], x.at[k].get_d(), 1e-15 * std::abs(x.at[k].get_d()));
    }
  }
}

TEST(ExactPoints, a_turn_has_the_sign_of_the_area_also_where_doubles_cannot_tell) {
  const ExactPoint a = exact_point({0, 0, 0});
  const ExactPoint b = exact_point({1, 1, 0});
  const ExactPoint third = point_between(a, b, mpq_class(1, 3));
  EXPECT_EQ(seen_turn(a, b, third, 2), 0);
  ExactPoint above = third;
  above.at[1] += mpq_class(1, mpz_class("1000000000000000000000000000000"));
  EXPECT_EQ(above.near.y, third.near.y);
  EXPECT_EQ(seen_turn(a, b, above, 2), 1);
  EXPECT_EQ(seen_turn(b, a, above, 2), -1);
}

TEST(ExactPoints, equal_points_have_one_number_and_those_that_round_alike_two) {
  ExactPoints points;
  const ExactPoint a = exact_point({0, 0, 0});
  const ExactPoint b = exact_point({3, 6, 9});
  const std::int32_t third = points.add(point_between(a, b, mpq_class(1, 3)));
  EXPECT_EQ(points.add(exact_point({1, 2, 3})), third);
  ExactPoint near = exact_point({1, 2, 3});
  near.at[0] += mpq_class(1, mpz_class("1000000000000000000000000000000"));
  EXPECT_NE(points.add(near), third);
  EXPECT_EQ(points.size(), 2);
}

}  // namespace
}  // namespace tetfarm
