#include "mesh/healing/equal_triangles.h"

#include <gmock/gmock.h>

#include "tests/mesh/healing/damaged_surface.h"

namespace tetfarm {
namespace {

using ::testing::SizeIs;

TEST(EqualTriangles, of_a_copy_the_first_stays) {
  test::Damaged box(shapes::box({0, 0, 0}, {1, 1, 1}, 2));
  const std::vector<Triangle> before = box.surface.triangles;
  const Triangle& n = before[5];
  test::add_copy(box.surface, 5, {n[1], n[2], n[0]});
  test::add_copy(box.surface, 5, {n[1], n[0], n[2]});
  EXPECT_EQ(remove_equal_triangles(box.work), 2);
  EXPECT_EQ(box.surface.triangles, before);
  ASSERT_THAT(box.acts, SizeIs(1));
  EXPECT_EQ(box.acts[0].kind, HealKind::duplicate);
}

TEST(EqualTriangles, two_that_close_nothing_both_go) {
  test::Damaged box(shapes::box({0, 0, 0}, {1, 1, 1}, 2));
  const std::vector<Triangle> before = box.surface.triangles;
  // A flap that stands on an edge: its other edges have these two alone.
  const Triangle& n = before[5];
  const auto tip = static_cast<std::int32_t>(box.surface.vertices.size());
  box.surface.vertices.push_back({3, 3, 3});
  test::add_copy(box.surface, 5, {n[0], n[1], tip});
  test::add_copy(box.surface, 5, {n[1], n[0], tip});
  EXPECT_EQ(remove_equal_triangles(box.work), 2);
  EXPECT_EQ(box.surface.triangles, before);
  ASSERT_THAT(box.acts, SizeIs(1));
  EXPECT_EQ(box.acts[0].kind, HealKind::fold);
}

TEST(EqualTriangles, of_a_surface_with_two_sides_one_stays) {
  test::Damaged box(shapes::box({0, 0, 0}, {1, 1, 1}, 2));
  const std::vector<Triangle> before = box.surface.triangles;
  for (std::size_t t = 0; t < before.size(); ++t) {
    test::add_copy(box.surface, t, {before[t][1], before[t][0], before[t][2]});
  }
  EXPECT_EQ(remove_equal_triangles(box.work), static_cast<std::int64_t>(before.size()));
  EXPECT_EQ(box.surface.triangles, before);
  EXPECT_EQ(box.acts.at(0).kind, HealKind::duplicate);
}

TEST(EqualTriangles, others_stay) {
  test::Damaged box(shapes::box({0, 0, 0}, {1, 1, 1}, 2));
  EXPECT_EQ(remove_equal_triangles(box.work), 0);
  EXPECT_EQ(box.surface.triangles, shapes::box({0, 0, 0}, {1, 1, 1}, 2).triangles);
}

}  // namespace
}  // namespace tetfarm
