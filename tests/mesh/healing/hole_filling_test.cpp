#include "mesh/healing/hole_filling.h"

#include <gmock/gmock.h>

#include "tests/mesh/healing/damaged_surface.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(HoleFilling, closes_holes_with_triangles_of_the_patch_beside) {
  SurfaceMesh box = shapes::box({0, 0, 0}, {1, 1, 1}, 4);
  box.patch_names = {"all", "other"};
  test::Damaged holed(box);
  const std::int32_t patch = patch_of(box, 20);
  for (const std::size_t t : {60U, 20U}) test::remove_triangle(holed.surface, t);
  EXPECT_EQ(fill_holes(holed.work), 2);
  EXPECT_THAT(test::defects_of(holed.surface), IsEmpty());
  EXPECT_THAT(holed.surface.triangles, SizeIs(box.triangles.size()));
  EXPECT_EQ(holed.surface.patch_of_triangle.back(), patch);
  EXPECT_NEAR(domain_volume(holed.surface), 1, 1e-12);
  EXPECT_THAT(holed.acts, SizeIs(2));
}

TEST(HoleFilling, leaves_holes_with_a_longer_border) {
  test::Damaged ball(shapes::sphere({0, 0, 0}, 1, 2));
  test::remove_triangle(ball.surface, 11);
  ball.work.largest_hole = 0.1;
  EXPECT_EQ(fill_holes(ball.work), 0);
  ball.work.largest_hole = 3;
  EXPECT_EQ(fill_holes(ball.work), 1);
  EXPECT_THAT(test::defects_of(ball.surface), IsEmpty());
}

TEST(HoleFilling, leaves_a_hole_that_something_is_in) {
  SurfaceMesh box = shapes::box({0, 0, 0}, {1, 1, 1}, 2);
  const TrianglePoints hole = points_of(box, 0);
  test::remove_triangle(box, 0);
  // A small body sticks through the hole.
  const Vec3 middle = (hole[0] + hole[1] + hole[2]) / 3.0;
  const SurfaceMesh pin =
      shapes::box(middle - Vec3{0.01, 0.01, 0.01}, middle + Vec3{0.01, 0.01, 0.01}, 1);
  test::Damaged stuck(test::with_body(box, pin));
  EXPECT_EQ(fill_holes(stuck.work), 0);
}

}  // namespace
}  // namespace tetfarm
