#include "mesh/remeshing/vertex_move.h"

#include <gmock/gmock.h>

#include "tests/mesh/remeshing/remeshing_fixture.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

/// One inside the top of a box with 4 x 4 squares on each side.
std::int32_t vertex_of_top(const ChangingSurface& surface) {
  for (std::int32_t v = 0; v < surface.vertex_end(); ++v) {
    if (surface.at(v) == Vec3{0.5, 0.5, 1}) return v;
  }
  return -1;
}

TEST(VertexMove, stays_where_it_was_put_when_that_may_be) {
  SurfaceToChange box(shapes::box({0, 0, 0}, {1, 1, 1}, 4), 0.25, 0.01);
  const std::int32_t v = vertex_of_top(box.surface);
  const Vec3 to{0.55, 0.45, 1};
  const VertexPlace before = try_vertex(box.work, v, {to, box.surface.vertex(v).foot});
  EXPECT_EQ(before.at, (Vec3{0.5, 0.5, 1}));
  EXPECT_TRUE(keep_or_put_back(box.work, v, before, true));
  EXPECT_EQ(box.surface.at(v), to);
  EXPECT_TRUE(box.surface.vertex(v).has_moved);
  EXPECT_THAT(complaints_of(box.surface), ::testing::IsEmpty());
}

TEST(VertexMove, is_taken_back_where_triangles_would_turn_over_or_nobody_wants_it) {
  SurfaceToChange box(shapes::box({0, 0, 0}, {1, 1, 1}, 4), 0.25, 0.01);
  const std::int32_t v = vertex_of_top(box.surface);
  const std::int32_t foot = box.surface.vertex(v).foot;
  for (const bool is_wanted : {true, false}) {
    const Vec3 to = is_wanted ? Vec3{0.9, 0.9, 1} : Vec3{0.55, 0.5, 1};
    const VertexPlace before = try_vertex(box.work, v, {to, foot + 1});
    EXPECT_FALSE(keep_or_put_back(box.work, v, before, is_wanted));
    EXPECT_EQ(box.surface.at(v), (Vec3{0.5, 0.5, 1}));
    EXPECT_EQ(box.surface.vertex(v).foot, foot);
    EXPECT_FALSE(box.surface.vertex(v).has_moved);
  }
}

}  // namespace
}  // namespace tetfarm
