#include "mesh/healing/border_loops.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/mesh/healing/damaged_surface.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAreArray;

TEST(BorderLoops, run_round_a_hole_as_its_triangle_did) {
  SurfaceMesh ball = shapes::sphere({0, 0, 0}, 1, 1);
  const Triangle gone = ball.triangles[9];
  test::remove_triangle(ball, 9);
  const std::vector<BorderLoop> loops = border_loops(edge_uses(ball.triangles));
  ASSERT_THAT(loops, SizeIs(1));
  const std::vector<std::int32_t>& loop = loops[0].vertices;
  ASSERT_THAT(loop, UnorderedElementsAreArray(gone));
  const auto first = std::ranges::find(loop, gone[0]) - loop.begin();
  EXPECT_EQ(loop[static_cast<std::size_t>(first + 1) % 3], gone[1]);
}

TEST(BorderLoops, are_none_of_a_closed_surface) {
  EXPECT_THAT(border_loops(edge_uses(shapes::unit_cube().triangles)), IsEmpty());
}

TEST(BorderLoops, through_a_vertex_where_two_begin_are_left_out) {
  // Two triangles that share a vertex alone.
  const std::vector<Triangle> bow = {{0, 1, 2}, {0, 3, 4}};
  EXPECT_THAT(border_loops(edge_uses(bow)), IsEmpty());
  const std::vector<Triangle> apart = {{0, 1, 2}, {5, 3, 4}};
  EXPECT_THAT(border_loops(edge_uses(apart)), SizeIs(2));
}

}  // namespace
}  // namespace tetfarm
