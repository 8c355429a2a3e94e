#include "mesh/cosmetics/climbing.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace tetfarm::cosmetics {
namespace {

TEST(ShortestInHull, of_one_vector_is_that_vector) {
  const std::array<Vec3, 1> one = {Vec3{1, -2, 3}};
  EXPECT_EQ(shortest_in_hull(one), (Vec3{1, -2, 3}));
}

TEST(ShortestInHull, of_two_is_where_the_way_between_them_comes_nearest) {
  const std::array<Vec3, 2> across = {Vec3{1, 1, 0}, Vec3{1, -1, 0}};
  EXPECT_NEAR(distance(shortest_in_hull(across), {1, 0, 0}), 0, 1e-12);
  // The nearer end where the way leads away from it.
  const std::array<Vec3, 2> behind = {Vec3{3, 0, 0}, Vec3{1, 0, 0}};
  EXPECT_NEAR(distance(shortest_in_hull(behind), {1, 0, 0}), 0, 1e-12);
}

TEST(ShortestInHull, of_vectors_on_all_sides_is_next_to_nothing) {
  const std::array<Vec3, 4> round = {Vec3{1, 0, 0}, Vec3{-1, 1, 0}, Vec3{-1, -1, 1},
                                     Vec3{-1, -1, -1}};
  EXPECT_LT(norm(shortest_in_hull(round)), 0.1);
}

TEST(ShortestInHull, points_to_the_side_of_all_of_them) {
  const std::array<Vec3, 3> vectors = {Vec3{1, 2, 0.5}, Vec3{2, -1, 0.25}, Vec3{0.5, 0.5, 3}};
  const Vec3 shortest = shortest_in_hull(vectors);
  for (const Vec3& v : vectors) {
    EXPECT_LE(norm(shortest), norm(v) + 1e-12);
    EXPECT_GT(dot(v, shortest), 0.99 * norm2(shortest));
  }
}

const Star corner_of_cube = {{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}},
                             {Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}}};

TEST(ShortestDistance, is_that_to_the_nearest_corner_of_all_faces) {
  EXPECT_EQ(shortest_distance2(corner_of_cube, {1, 1, 0.5}), 0.25);
  EXPECT_EQ(shortest_distance2(corner_of_cube, {0, 0, 3}), 4);
  EXPECT_EQ(shortest_distance2(corner_of_cube, {1, 0, 0}), 0);
}

/// Highest where the node has all three coordinates: told by the first corner of a face alone.
struct Hill {
  double operator()(const StarFace& face, const Vec3& p) const {
    return 1 - norm2(p - face[0] - Vec3{0.25, 0.25, 0.25});
  }
};

TEST(WorstAt, is_the_least_of_all_faces_and_may_stop_below_a_bound) {
  const Hill hill;
  const Vec3 p{1, 1, 1};
  const Star star = {{Vec3{0, 0, 0}, {}, {}}, {Vec3{1, 0, 0}, {}, {}}, {Vec3{-3, 0, 0}, {}, {}}};
  EXPECT_EQ(worst_at(star, p, -HUGE_VAL, hill), hill(star[2], p));
  EXPECT_EQ(worst_at(star, p, 10, hill), hill(star[0], p)) << "below at the first";
}

TEST(Climb, comes_to_the_top_of_a_hill_and_never_lower_than_it_began) {
  const Star star = {{Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{0, 2, 0}}};
  const Vec3 start{0.9, 0.8, 0.7};
  const Place top = climb(star, start, 10.0, Hill{});
  EXPECT_EQ(top.worst, Hill{}(star[0], top.point));
  EXPECT_GT(top.worst, 0.99);
  EXPECT_LT(distance(top.point, {0.25, 0.25, 0.25}), 0.1);
}

TEST(Climb, stops_where_it_is_good_enough) {
  const Star star = {{Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{0, 2, 0}}};
  const Vec3 start{0.9, 0.8, 0.7};
  const Place there = climb(star, start, Hill{}(star[0], start), Hill{});
  EXPECT_EQ(there.point, start) << "it is so from the beginning";
  const Place half = climb(star, start, 0.3, Hill{});
  EXPECT_GE(half.worst, 0.3);
  EXPECT_LT(half.worst, climb(star, start, 10.0, Hill{}).worst);
}

TEST(Climb, stays_where_the_node_lies_on_a_corner) {
  const Star star = {{Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{0, 2, 0}}};
  EXPECT_EQ(climb(star, {2, 0, 0}, 10.0, Hill{}).point, (Vec3{2, 0, 0}));
}

}  // namespace
}  // namespace tetfarm::cosmetics
