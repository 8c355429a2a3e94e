#include "mesh/healing/crossing_replacement.h"

#include <gmock/gmock.h>

#include "tests/mesh/healing/damaged_surface.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A box one of whose vertices in the top lies beyond its neighbours: the top folds over.
SurfaceMesh folded_box(double beyond) {
  SurfaceMesh box = shapes::box({0, 0, 0}, {1, 1, 1}, 6);
  for (Vec3& v : box.vertices) {
    if (v.z == 1 && std::abs(v.x - 0.5) < 1e-9 && std::abs(v.y - 0.5) < 1e-9) v.x += beyond;
  }
  return box;
}

std::vector<char> crossing(const SurfaceMesh& surface) {
  std::vector<char> is_crossing(surface.triangles.size(), 0);
  for (const SurfaceDefect& defect : test::defects_of(surface)) {
    for (const std::int64_t t : defect.triangles) is_crossing[static_cast<std::size_t>(t)] = 1;
  }
  return is_crossing;
}

TEST(CrossingReplacement, unfolds_a_side_that_lies_over_itself) {
  test::Damaged box(folded_box(0.2));
  ASSERT_FALSE(test::defects_of(box.surface).empty());
  EXPECT_EQ(replace_crossings(box.work, crossing(box.surface)), 1);
  EXPECT_THAT(test::defects_of(box.surface), IsEmpty());
  EXPECT_NEAR(domain_volume(box.surface), 1, 1e-12);
  ASSERT_THAT(box.acts, SizeIs(1));
  EXPECT_EQ(box.acts[0].kind, HealKind::crossing);
}

TEST(CrossingReplacement, is_no_farther_off_than_allowed) {
  SurfaceMesh ball = shapes::sphere({0, 0, 0}, 1, 2);
  // A dent so deep that it comes out on the other side.
  ball.vertices[0] = -1.5 * ball.vertices[0];
  test::Damaged dented(ball);
  dented.work.largest_move = 0.1;
  EXPECT_EQ(replace_crossings(dented.work, crossing(ball)), 0);
  EXPECT_EQ(dented.surface.triangles, ball.triangles);
}

TEST(CrossingReplacement, leaves_bodies_that_go_through_each_other) {
  const SurfaceMesh two = test::with_body(shapes::box({0, 0, 0}, {1, 1, 1}, 1),
                                          shapes::box({0.5, 0.4, 0.3}, {2, 0.9, 0.8}, 1));
  test::Damaged crossed(two);
  crossed.work.largest_move = 1e-3;
  EXPECT_EQ(replace_crossings(crossed.work, crossing(two)), 0);
}

}  // namespace
}  // namespace tetfarm
