#include "mesh/healing/vertex_welding.h"

#include <gmock/gmock.h>

#include "tests/mesh/healing/damaged_surface.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(VertexWelding, closes_a_crack_below_the_tolerance) {
  test::Damaged box(shapes::box({0, 0, 0}, {1, 1, 1}, 3));
  const SurfaceMesh before = box.surface;
  test::tear(box.surface, 7, {1e-7, 0, 0});
  ASSERT_FALSE(test::defects_of(box.surface).empty());
  EXPECT_EQ(weld_vertices(box.work, test::all_of(box.surface)), 1);
  EXPECT_EQ(box.surface.triangles, before.triangles) << "into the vertex that was there first";
  ASSERT_THAT(box.acts, SizeIs(1));
  EXPECT_EQ(box.acts[0].kind, HealKind::joined);
}

TEST(VertexWelding, leaves_a_wider_crack) {
  test::Damaged box(shapes::box({0, 0, 0}, {1, 1, 1}, 3));
  test::tear(box.surface, 7, {1e-5, 0, 0});
  EXPECT_EQ(weld_vertices(box.work, test::all_of(box.surface)), 0);
  EXPECT_THAT(box.acts, IsEmpty());
}

TEST(VertexWelding, leaves_closed_sheets_alone_however_near) {
  const SurfaceMesh two = test::with_body(shapes::box({0, 0, 0}, {1, 1, 1}, 1),
                                          shapes::box({1 + 1e-8, 0, 0}, {2, 1, 1}, 1));
  test::Damaged near(two);
  EXPECT_EQ(weld_vertices(near.work, test::all_of(near.surface)), 0);
}

TEST(VertexWelding, draws_short_edges_of_defective_triangles_together_and_no_others) {
  SurfaceMesh box = shapes::box({0, 0, 0}, {1, 1, 1}, 2);
  // Vertex 0 and a vertex next to it nearly coincide.
  const std::int32_t other = box.triangles[0][0] == 0 ? box.triangles[0][1] : box.triangles[0][0];
  box.vertices[static_cast<std::size_t>(other)] = box.vertices[0] + Vec3{1e-8, 1e-8, 1e-8};
  const bool are_neighbours =
      box.triangles[0][0] == 0 || box.triangles[0][1] == 0 || box.triangles[0][2] == 0;
  ASSERT_TRUE(are_neighbours);
  test::Damaged short_edge(box);
  EXPECT_EQ(weld_vertices(short_edge.work, std::vector<char>(box.triangles.size(), 0)), 0);
  EXPECT_EQ(weld_vertices(short_edge.work, test::all_of(box)), 1);
  EXPECT_THAT(short_edge.surface.triangles, SizeIs(box.triangles.size() - 2));
  EXPECT_THAT(short_edge.surface.patch_of_triangle, SizeIs(box.patch_of_triangle.size() - 2));
}

}  // namespace
}  // namespace tetfarm
