#include "mesh/cosmetics/smoothing.h"

#include <gmock/gmock.h>

#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm::cosmetics {
namespace {

using testing::IsEmpty;
using trial::box_with_inner_node;

TEST(Smoothing, brings_a_node_back_to_the_middle) {
  TetComplex complex = box_with_inner_node({1.5, 1.4, 1.3});
  ASSERT_THAT(validate(complex), IsEmpty());
  WorkMesh work(complex, 26);
  const std::vector<std::int32_t> ball = ball_of_node(work, 26);
  const double before = worst_of(work, ball);
  const auto place = find_move(work, ball, 26, 0.5);
  ASSERT_TRUE(place.has_value());
  EXPECT_TRUE(move_node(work, ball, 26, place->point));
  EXPECT_EQ(worst_of(work, ball), place->worst);
  EXPECT_GT(place->worst, 2 * before);
  EXPECT_LT(distance(work.point(26), {1, 1, 1}), 0.3);
  EXPECT_THAT(validate(complex), IsEmpty());
}

TEST(Smoothing, never_ends_below_its_start) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    TetComplex complex = box_with_inner_node(Vec3{1, 1, 1} + 0.9 * trial::random_vector(3, seed));
    WorkMesh work(complex, 26);
    const std::vector<std::int32_t> ball = ball_of_node(work, 26);
    const Star star = star_of(work, ball, 26);
    const double before = worst_of(work, ball);
    const Place place = climb(star, work.point(26), 0.5);
    EXPECT_GE(place.worst, before);
    EXPECT_GT(place.worst, 0.15) << "seed " << seed << " from " << before;
  }
}

TEST(Smoothing, climbs_out_of_an_inverted_start) {
  TetComplex complex = box_with_inner_node({1, 1, 1});
  WorkMesh work(complex, 26);
  const Star star = star_of(work, ball_of_node(work, 26), 26);
  EXPECT_GT(climb(star, {2.05, 1, 1}, 0.5).worst, 0);
}

TEST(Smoothing, refuses_to_turn_a_tet_over) {
  TetComplex complex = box_with_inner_node({1, 1, 1});
  WorkMesh work(complex, 26);
  const std::vector<std::int32_t> ball = ball_of_node(work, 26);
  EXPECT_FALSE(move_node(work, ball, 26, {2, 1, 1}));
  EXPECT_FALSE(move_node(work, ball, 26, {3, 1, 1}));
  EXPECT_EQ(work.point(26), (Vec3{1, 1, 1}));
}

}  // namespace
}  // namespace tetfarm::cosmetics
