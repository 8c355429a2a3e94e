#include "mesh/layers/layer_coverage.h"

#include <gmock/gmock.h>

#include "tests/mesh/layers/layered_sphere.h"

namespace tetfarm {
namespace {

using test::LayeredSphere;
using testing::IsEmpty;
using testing::Pair;
using testing::UnorderedElementsAre;

TEST(LayerCoverage, is_full_where_every_line_has_what_it_was_asked_for) {
  const LayeredSphere sphere;
  const LayerCoverage coverage = coverage_of(sphere.plan, sphere.surface);
  EXPECT_EQ(coverage.wall_triangles, std::ssize(sphere.surface.triangles));
  EXPECT_EQ(coverage.full, coverage.wall_triangles);
  EXPECT_EQ(coverage.partial(), 0);
  EXPECT_EQ(coverage.none, 0);
  EXPECT_THAT(coverage.short_lines, IsEmpty());
}

TEST(LayerCoverage, tells_of_what_is_short_and_why) {
  LayeredSphere sphere;
  const std::int32_t wall = sphere.plan.wall.at(0);
  for (const std::int32_t line : lines_of(sphere.plan, sphere.surface, wall)) {
    sphere.plan.lines[static_cast<std::size_t>(line)].stop = 0;
    sphere.plan.lines[static_cast<std::size_t>(line)].reason = StopReason::no_room;
  }
  sphere.plan.lines.back().reason = StopReason::ridge;
  const LayerCoverage coverage = coverage_of(sphere.plan, sphere.surface);
  EXPECT_EQ(coverage.none, 1);
  EXPECT_GT(coverage.partial(), 8) << "all round it";
  EXPECT_LT(coverage.partial(), 18);
  EXPECT_THAT(coverage.short_lines,
              UnorderedElementsAre(Pair(StopReason::no_room, 3), Pair(StopReason::ridge, 1)));
}

}  // namespace
}  // namespace tetfarm
