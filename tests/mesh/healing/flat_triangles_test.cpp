#include "mesh/healing/flat_triangles.h"

#include <gmock/gmock.h>

#include "tests/mesh/healing/damaged_surface.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(FlatTriangles, go_and_the_ones_beyond_are_divided) {
  test::Damaged box(shapes::box({0, 0, 0}, {1, 1, 1}, 2));
  const std::size_t before = box.surface.triangles.size();
  test::add_flat_triangle(box.surface, 3);
  ASSERT_THAT(box.surface.triangles, SizeIs(before + 2));
  ASSERT_FALSE(test::defects_of(box.surface).empty());
  EXPECT_EQ(remove_flat_triangles(box.work), 1);
  EXPECT_THAT(test::defects_of(box.surface), IsEmpty());
  EXPECT_THAT(box.surface.triangles, SizeIs(before + 2));
  EXPECT_NEAR(domain_volume(box.surface), 1, 1e-12);
  ASSERT_THAT(box.acts, SizeIs(1));
  EXPECT_EQ(box.acts[0].kind, HealKind::flat);
}

TEST(FlatTriangles, one_against_another_go_pass_by_pass) {
  test::Damaged box(shapes::box({0, 0, 0}, {1, 1, 1}, 1));
  test::add_flat_triangle(box.surface, 0);
  // Over the flat one lies a second, on the half of its long side.
  test::add_flat_triangle(box.surface, box.surface.triangles.size() - 2);
  EXPECT_EQ(remove_flat_triangles(box.work), 2);
  EXPECT_THAT(test::defects_of(box.surface), IsEmpty());
  EXPECT_NEAR(domain_volume(box.surface), 1, 1e-12);
}

TEST(FlatTriangles, with_area_stay) {
  test::Damaged ball(shapes::sphere({0, 0, 0}, 1, 1));
  EXPECT_EQ(remove_flat_triangles(ball.work), 0);
  EXPECT_THAT(ball.acts, IsEmpty());
}

}  // namespace
}  // namespace tetfarm
