#include "mesh/planar/planar_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/mesh/planar/regions.h"

namespace tetfarm {
namespace {

using planar_test::rectangle;
using planar_test::whats_wrong;
using ::testing::IsEmpty;

PlanarSpacing uniform(double h) {
  return [h](const Vec2&) { return h; };
}

TEST(PlanarMesh, fills_a_square) {
  const PlanarRegion region = rectangle({0, 0}, {1, 1}, 10);
  const PlanarResult result = mesh_region(region, uniform(0.1));
  ASSERT_FALSE(result.failure);
  EXPECT_THAT(whats_wrong(region, result.mesh), IsEmpty());
  EXPECT_GT(result.mesh.points.size(), region.points.size());
}

TEST(PlanarMesh, splits_forbidden_chords) {
  const PlanarRegion region = rectangle({0, 0}, {1, 1}, 1);
  const PlanarMesh plain = mesh_region(region, uniform(9)).mesh;
  ASSERT_EQ(plain.triangles.size(), 2U);
  const PlanarMesh split =
      mesh_region(region, uniform(9), {.forbidden_chords = {{0, 2}, {3, 1}}}).mesh;
  EXPECT_THAT(whats_wrong(region, split), IsEmpty());
  EXPECT_EQ(split.points.size(), 5U);
  EXPECT_EQ(split.triangles.size(), 4U);
}

TEST(PlanarMesh, refuses_an_open_loop_and_says_where) {
  PlanarRegion region = rectangle({0, 0}, {1, 1}, 2);
  region.edges.pop_back();
  const PlanarResult result = mesh_region(region, uniform(0.5));
  ASSERT_TRUE(result.failure);
  EXPECT_EQ(result.failure->reason, "a loop does not close");
  EXPECT_THAT(result.failure->where, ::testing::UnorderedElementsAre(Vec2{0, 0}, Vec2{0, 0.5}));
}

TEST(PlanarMesh, refuses_crossing_edges_and_says_where) {
  PlanarRegion region;
  planar_test::add_loop(region, {{0, 0}, {2, 0}, {0, 2}, {2, 2}});
  const PlanarResult result = mesh_region(region, uniform(0.5));
  ASSERT_TRUE(result.failure);
  EXPECT_EQ(result.failure->reason, "two edges cross");
  EXPECT_THAT(result.failure->where, ::testing::ElementsAre(Vec2{1, 1}));
}

TEST(PlanarMesh, fills_an_annulus_and_an_island_in_its_hole) {
  PlanarRegion region;
  planar_test::add_loop(region, planar_test::circle_loop({0, 0}, 3, 90));
  planar_test::add_loop(region, planar_test::circle_loop({0, 0}, -2, 60));
  planar_test::add_loop(region, planar_test::circle_loop({0.3, 0.2}, 1, 30));
  const PlanarResult result = mesh_region(region, uniform(0.2));
  ASSERT_FALSE(result.failure);
  EXPECT_THAT(whats_wrong(region, result.mesh), IsEmpty());
}

}  // namespace
}  // namespace tetfarm
