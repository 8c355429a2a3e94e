#include "mesh/remeshing/edge_collapse.h"

#include <gmock/gmock.h>

#include "mesh/remeshing/edge_split.h"
#include "tests/mesh/remeshing/remeshing_fixture.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;

TEST(EdgeCollapse, never_takes_a_corner) {
  SurfaceToChange cube(shapes::unit_cube(), 10, 1);
  const std::array<std::int32_t, 2> edge = cube.features.edges.front();
  EXPECT_FALSE(collapse_edge(cube.work, edge[0], edge[1], 10, 0));
  EXPECT_EQ(cube.surface.triangle_count(), 12);
}

TEST(EdgeCollapse, undoes_a_split_of_a_feature_edge) {
  SurfaceToChange cube(shapes::unit_cube(), 10, 0.01);
  const std::array<std::int32_t, 2> edge = cube.features.edges.front();
  ASSERT_TRUE(split_edge(cube.work, edge[0], edge[1]));
  const std::int32_t middle = cube.surface.vertex_end() - 1;
  ASSERT_TRUE(collapse_edge(cube.work, middle, edge[1], 10, 0));
  EXPECT_EQ(cube.surface.triangle_count(), 12);
  EXPECT_NEAR(volume_of(cube.surface), 1, 1e-15);
  EXPECT_THAT(complaints_of(cube.surface), IsEmpty());
}

TEST(EdgeCollapse, takes_a_vertex_off_its_curve_by_no_way) {
  SurfaceToChange box(shapes::box({0, 0, 0}, {1, 1, 1}, 3), 10, 0.01);
  for (std::int32_t v = 0; v < box.surface.vertex_end(); ++v) {
    if (box.surface.vertex(v).kind != VertexKind::on_curve) continue;
    const std::vector<std::int32_t> ring(box.surface.ring(v).begin(), box.surface.ring(v).end());
    for (const std::int32_t t : ring) {
      for (const std::int32_t w : box.surface.triangle(t).nodes) {
        if (box.surface.vertex(w).kind != VertexKind::smooth) continue;
        EXPECT_FALSE(collapse_edge(box.work, v, w, 10, 0)) << v << " into " << w;
      }
    }
  }
}

TEST(EdgeCollapse, leaves_what_would_depart_from_the_input_by_more_than_the_tolerance) {
  SurfaceToChange fine(shapes::sphere({0, 0, 0}, 1, 1), 10, 0.001);
  const Triangle t = fine.surface.triangle(0).nodes;
  EXPECT_FALSE(collapse_edge(fine.work, t[0], t[1], 10, 0));
  SurfaceToChange coarse(shapes::sphere({0, 0, 0}, 1, 1), 10, 0.2);
  EXPECT_TRUE(collapse_edge(coarse.work, t[0], t[1], 10, 0));
  EXPECT_THAT(complaints_of(coarse.surface), IsEmpty());
}

TEST(EdgeCollapse, leaves_a_tetrahedron_as_it_is) {
  SurfaceToChange smallest(shapes::tetrahedron(), 10, 10);
  for (std::int32_t a = 0; a < 4; ++a) {
    for (std::int32_t b = 0; b < 4; ++b) {
      if (a == b) continue;
      EXPECT_FALSE(collapse_edge(smallest.work, a, b, 10, 0));
    }
  }
}

TEST(EdgeCollapse, makes_no_edge_longer_than_asked) {
  SurfaceToChange box(shapes::box({0, 0, 0}, {1, 1, 1}, 4), 1, 0.01);
  std::int32_t inside = -1;
  for (std::int32_t v = 0; v < box.surface.vertex_end(); ++v) {
    if (box.surface.vertex(v).kind == VertexKind::smooth) inside = v;
  }
  ASSERT_GE(inside, 0);
  const Triangle t = box.surface.triangle(box.surface.ring(inside).front()).nodes;
  const std::int32_t other = t[0] == inside ? t[1] : t[0];
  EXPECT_FALSE(collapse_edge(box.work, inside, other, 0.26, 0));
  EXPECT_TRUE(collapse_edge(box.work, inside, other, 1, 0));
}

}  // namespace
}  // namespace tetfarm
