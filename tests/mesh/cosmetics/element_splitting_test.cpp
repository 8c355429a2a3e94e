#include "mesh/cosmetics/element_splitting.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "mesh/cosmetics/quality.h"
#include "tests/mesh/cosmetics/spindle.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm::cosmetics {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

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

TEST(ElementSplitting, of_bad_tets_in_random_meshes_leaves_them_better_and_whole) {
  TetComplex complex = make_tet_complex(trial::random_ball(2, 60, 8));
  WorkMesh work(complex, 162);
  const double whole = volume(complex);
  const SplitOptions options{.least_distance = 0.05};
  int splits = 0;
  for (std::int32_t t = 0; t < std::ssize(complex.nodes) && splits < 20; ++t) {
    if (!complex.is_live(t) || work.quality_of(t) > 0.02) continue;
    const auto found = find_split(work, t, options);
    if (!found) continue;
    EXPECT_EQ(std::count(found->old_tets.begin(), found->old_tets.end(), t), 1);
    EXPECT_EQ(found->old_worst, worst_of(work, found->old_tets));
    EXPECT_GT(found->new_worst, found->old_worst);
    ASSERT_TRUE(found->new_point.has_value());
    for (const std::int32_t old : found->old_tets) {
      for (const std::int32_t v : work.tet(old)) {
        EXPECT_GE(distance(work.point(v), *found->new_point), options.least_distance);
      }
    }
    const std::vector<std::int32_t> tets = replace_tets(work, *found);
    ASSERT_EQ(tets.size(), found->new_tets.size());
    EXPECT_NEAR(worst_of(work, tets), found->new_worst, 1e-12);
    ++splits;
  }
  EXPECT_GT(splits, 5);
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_NEAR(volume(complex), whole, 1e-12);
}

}  // namespace
}  // namespace tetfarm::cosmetics
