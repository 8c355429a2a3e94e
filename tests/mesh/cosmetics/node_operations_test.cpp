#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "mesh/cosmetics/element_collapse.h"
#include "mesh/cosmetics/element_splitting.h"
#include "mesh/cosmetics/quality.h"
#include "mesh/cosmetics/smoothing.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm::cosmetics {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

/// A box of 2^3 cubes whose one inner node, number 26, lies at `inner` instead of (1, 1, 1).
TetComplex box_with_inner_node(const Vec3& inner) {
  TetMesh mesh = trial::kuhn_box(2);
  mesh.nodes[26] = inner;
  return make_tet_complex(mesh);
}

TEST(BallOfNode, is_all_tets_that_hold_the_node) {
  TetComplex complex = make_tet_complex(trial::kuhn_box(3));
  WorkMesh work(complex, 56);
  for (std::int32_t v = 0; v < 64; ++v) {
    const std::vector<std::int32_t> ball = ball_of_node(work, v);
    std::size_t holders = 0;
    for (std::int32_t t = 0; t < 162; ++t) holders += complex.local_node(t, v) >= 0;
    EXPECT_EQ(ball.size(), holders);
    for (const std::int32_t t : ball) EXPECT_GE(complex.local_node(t, v), 0);
  }
}

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

TEST(ElementCollapse, removes_a_node_that_lies_close_to_another) {
  TetComplex complex = box_with_inner_node({1.97, 1, 1});
  ASSERT_THAT(validate(complex), IsEmpty());
  WorkMesh work(complex, 26);
  std::int32_t near = -1;
  for (std::int32_t v = 0; v < 26; ++v) {
    if (work.point(v) == Vec3{2, 1, 1}) near = v;
  }
  const std::vector<std::int32_t> ball = ball_of_node(work, 26);
  const auto found = find_collapse(work, ball, 26, near, 0);
  ASSERT_TRUE(found.has_value());
  EXPECT_LT(found->new_tets.size(), found->old_tets.size());
  EXPECT_FALSE(replace_tets(work, *found).empty());
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_EQ(complex.node2tet[26], -1);
}

TEST(ElementCollapse, is_nothing_when_it_makes_flat_tets) {
  TetComplex complex = box_with_inner_node({1, 1, 1});
  WorkMesh work(complex, 26);
  const std::vector<std::int32_t> ball = ball_of_node(work, 26);
  for (std::int32_t onto = 0; onto < 26; ++onto) {
    EXPECT_FALSE(find_collapse(work, ball, 26, onto, 0).has_value());
  }
}

/// A sliver, tet 0, of four nodes round the equator, with two caps to each pole.
TetComplex sliver_between_poles() {
  TetMesh mesh;
  mesh.nodes = {{1, 0, 0.02}, {-1, 0, 0.02}, {0, 1, -0.02}, {0, -1, -0.02}, {0, 0, 1}, {0, 0, -1}};
  mesh.tets = {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 3, 4}, {0, 2, 3, 5}, {1, 2, 3, 5}};
  for (Tet& tet : mesh.tets) {
    const auto point = [&](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(tet[i])]; };
    if (tet_volume(point(0), point(1), point(2), point(3)) < 0) std::swap(tet[0], tet[1]);
  }
  return make_tet_complex(mesh);
}

TEST(ElementSplitting, breaks_a_sliver_of_boundary_nodes) {
  TetComplex complex = sliver_between_poles();
  ASSERT_THAT(validate(complex), IsEmpty());
  WorkMesh work(complex, 6);
  ASSERT_LT(work.quality_of(0), 0.01);
  const auto found = find_split(work, 0, {});
  ASSERT_TRUE(found.has_value());
  EXPECT_GT(found->new_worst, 0.1);
  EXPECT_FALSE(replace_tets(work, *found).empty());
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_THAT(complex.points, SizeIs(7));
  EXPECT_GE(complex.node2tet[6], 0);
}

TEST(ElementSplitting, keeps_the_distance_that_is_asked_for) {
  TetComplex complex = sliver_between_poles();
  WorkMesh work(complex, 6);
  EXPECT_FALSE(find_split(work, 0, {.least_distance = 1.2}).has_value());
}

/// A cone over a polygon whose node 0 lies a little lower than the others. Its base is a fan of
/// triangles from node 0, its tets stand on one from node 1: between the two is a chain of flat
/// tets, the first ones of the mesh.
TetComplex cone_over_flat_tets(std::int32_t corners) {
  TetMesh mesh;
  for (std::int32_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    mesh.nodes.push_back({std::cos(angle), std::sin(angle), i == 0 ? -1e-9 : 0.0});
  }
  mesh.nodes.push_back({0, 0, 1});
  for (std::int32_t i = 2; i + 1 < corners; ++i) mesh.tets.push_back({0, 1, i, i + 1});
  for (std::int32_t i = 2; i < corners; ++i) {
    mesh.tets.push_back({1, i, (i + 1) % corners, corners});
  }
  for (Tet& tet : mesh.tets) {
    const auto point = [&](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(tet[i])]; };
    if (tet_volume(point(0), point(1), point(2), point(3)) < 0) std::swap(tet[0], tet[1]);
  }
  return make_tet_complex(mesh);
}

TEST(ElementSplitting, breaks_a_whole_layer_of_flat_tets_from_beside_their_plane) {
  constexpr std::int32_t corners = 48;
  TetComplex complex = cone_over_flat_tets(corners);
  ASSERT_THAT(validate(complex), IsEmpty());
  WorkMesh work(complex, corners + 1);
  const std::int32_t in_the_middle = corners / 2;
  ASSERT_LT(work.quality_of(in_the_middle), 1e-12);
  EXPECT_FALSE(find_split(work, in_the_middle, {}).has_value());
  const auto found = find_split(work, in_the_middle, {.is_flat = true});
  ASSERT_TRUE(found.has_value());
  EXPECT_GT(found->new_worst, quality_of_angle(2));
  EXPECT_GT(found->old_tets.size(), 40U);
  EXPECT_FALSE(replace_tets(work, *found).empty());
  EXPECT_THAT(validate(complex), IsEmpty());
}

}  // namespace
}  // namespace tetfarm::cosmetics
