#include "mesh/remeshing/edge_split.h"

#include <gmock/gmock.h>

#include "tests/mesh/remeshing/remeshing_fixture.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(EdgeSplit, puts_a_vertex_of_the_curve_on_a_feature_edge) {
  SurfaceToChange cube(shapes::unit_cube(), 0.5, 0.01);
  const std::array<std::int32_t, 2> edge = cube.features.edges.front();
  ASSERT_TRUE(split_edge(cube.work, edge[0], edge[1]));
  const std::int32_t middle = cube.surface.vertex_end() - 1;
  EXPECT_EQ(cube.surface.vertex(middle).kind, VertexKind::on_curve);
  EXPECT_THAT(cube.surface.feature_neighbours(middle), ::testing::ElementsAre(edge[0], edge[1]));
  EXPECT_EQ(cube.surface.triangle_count(), 14);
  EXPECT_NEAR(volume_of(cube.surface), 1, 1e-15);
  EXPECT_THAT(complaints_of(cube.surface), IsEmpty());
}

TEST(EdgeSplit, of_an_edge_inside_a_face_makes_a_smooth_vertex_on_the_input) {
  SurfaceToChange sphere(shapes::sphere({0, 0, 0}, 1, 1), 0.2, 0.05);
  const Triangle t = sphere.surface.triangle(0).nodes;
  ASSERT_TRUE(split_edge(sphere.work, t[0], t[1]));
  const std::int32_t middle = sphere.surface.vertex_end() - 1;
  EXPECT_EQ(sphere.surface.vertex(middle).kind, VertexKind::smooth);
  EXPECT_THAT(sphere.surface.ring(middle), SizeIs(4));
  EXPECT_THAT(complaints_of(sphere.surface), IsEmpty());
}

TEST(EdgeSplit, does_nothing_where_there_is_no_edge) {
  SurfaceToChange sphere(shapes::sphere({0, 0, 0}, 1, 1), 0.2, 0.05);
  const std::int32_t before = sphere.surface.vertex_end();
  const std::int32_t far = sphere.surface.triangle(40).nodes[0];
  ASSERT_FALSE(sphere.surface.has_edge(0, far));
  EXPECT_FALSE(split_edge(sphere.work, 0, far));
  EXPECT_EQ(sphere.surface.vertex_end(), before);
}

}  // namespace
}  // namespace tetfarm
