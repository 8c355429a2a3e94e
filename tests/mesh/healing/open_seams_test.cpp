#include "mesh/healing/open_seams.h"

#include <gmock/gmock.h>

#include "tests/mesh/healing/damaged_surface.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(OpenSeams, are_closed_where_a_vertex_lies_on_an_edge) {
  test::Damaged box(shapes::box({0, 0, 0}, {1, 1, 1}, 2));
  const std::size_t before = box.surface.triangles.size();
  test::divide_one_side(box.surface, 4);
  ASSERT_FALSE(test::defects_of(box.surface).empty());
  EXPECT_EQ(divide_open_edges(box.work), 1);
  EXPECT_THAT(test::defects_of(box.surface), IsEmpty());
  EXPECT_THAT(box.surface.triangles, SizeIs(before + 2));
  EXPECT_NEAR(domain_volume(box.surface), 1, 1e-12);
}

TEST(OpenSeams, are_divided_at_all_vertices_of_the_other_side_in_order) {
  test::Damaged box(shapes::box({0, 0, 0}, {1, 1, 1}, 1));
  test::divide_one_side(box.surface, 0);
  test::divide_one_side(box.surface, 0);
  test::divide_one_side(box.surface, box.surface.triangles.size() - 2);
  EXPECT_EQ(divide_open_edges(box.work), 1);
  EXPECT_THAT(test::defects_of(box.surface), IsEmpty());
  EXPECT_THAT(box.acts.at(0).triangles, SizeIs(4));
}

TEST(OpenSeams, are_left_where_the_vertex_is_farther_off_than_the_tolerance) {
  test::Damaged box(shapes::box({0, 0, 0}, {1, 1, 1}, 2));
  test::divide_one_side(box.surface, 4);
  box.surface.vertices.back() += Vec3{1e-4, 1e-4, 1e-4};
  EXPECT_EQ(divide_open_edges(box.work), 0);
}

TEST(OpenSeams, of_a_sound_surface_are_none) {
  test::Damaged box(shapes::box({0, 0, 0}, {1, 1, 1}, 2));
  EXPECT_EQ(divide_open_edges(box.work), 0);
  EXPECT_EQ(box.surface.triangles, shapes::box({0, 0, 0}, {1, 1, 1}, 2).triangles);
}

}  // namespace
}  // namespace tetfarm
