#include "mesh/layers/layer_coverage.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/mesh/layers/layered_sphere.h"

namespace tetfarm {
namespace {

using test::LayeredSphere;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

LayerCoverage coverage_of(const LayeredSphere& sphere) {
  return coverage_of(wall_layers(sphere.plan, sphere.surface));
}

TEST(LayerCoverage, is_full_where_every_line_has_what_it_was_asked_for) {
  const LayerCoverage coverage = coverage_of(LayeredSphere());
  EXPECT_EQ(coverage.wall_triangles, std::ssize(LayeredSphere().surface.triangles));
  EXPECT_EQ(coverage.full, coverage.wall_triangles);
  EXPECT_EQ(coverage.partial(), 0);
  EXPECT_EQ(coverage.none, 0);
  EXPECT_EQ(coverage.with_first, coverage.wall_triangles);
  EXPECT_EQ(coverage.first_within_2, coverage.wall_triangles);
  EXPECT_THAT(coverage.short_of_layers, IsEmpty());
}

/// The three lines of the first wall triangle end at once.
LayeredSphere bare_at_first_triangle() {
  LayeredSphere sphere;
  for (const std::int32_t line : lines_of(sphere.plan, sphere.surface, sphere.plan.wall.at(0))) {
    LayerLine& ends = sphere.plan.lines[static_cast<std::size_t>(line)];
    ends.stop = 0;
    ends.reason = StopReason::no_room;
    ends.because_of = 17;
  }
  return sphere;
}

TEST(LayerCoverage, tells_of_what_is_short_and_why) {
  const LayerCoverage coverage = coverage_of(bare_at_first_triangle());
  EXPECT_EQ(coverage.none, 1);
  EXPECT_GT(coverage.partial(), 8) << "all round it";
  EXPECT_LT(coverage.partial(), 18);
  EXPECT_EQ(coverage.with_first, coverage.full);
  EXPECT_THAT(coverage.short_of_layers,
              ElementsAre(Pair(StopReason::no_room, 1 + coverage.partial())));
}

TEST(LayerCoverage, counts_first_heights_that_are_not_as_asked) {
  LayeredSphere sphere;
  for (LayerLine& line : sphere.plan.lines) line.first_wanted *= 1.05;
  const LayerCoverage coverage = coverage_of(sphere);
  EXPECT_EQ(coverage.first_within_2, 0);
  EXPECT_EQ(coverage.first_within_10, coverage.wall_triangles);
}

TEST(LayerCoverage, of_a_triangle_has_its_layers_their_heights_and_why_there_are_no_more) {
  const LayeredSphere sphere = bare_at_first_triangle();
  const std::vector<WallLayers> walls = wall_layers(sphere.plan, sphere.surface);
  EXPECT_EQ(walls[0].layers, 0);
  EXPECT_EQ(walls[0].cells, 0);
  EXPECT_EQ(walls[0].wanted, 5);
  EXPECT_EQ(walls[0].reason, StopReason::no_room);
  EXPECT_EQ(walls[0].because_of, 17);
  const auto full = std::find_if(walls.begin(), walls.end(),
                                 [](const WallLayers& wall) { return wall.layers == 5; });
  ASSERT_NE(full, walls.end());
  EXPECT_EQ(full->reason, StopReason::complete);
  EXPECT_NEAR(full->first_height, 0.01, 1e-4);
  const HeightLaw& law = sphere.plan.lines.front().law;
  EXPECT_NEAR(full->total_height, total_height(law, 5), 0.01 * total_height(law, 5));
}

TEST(LayerCoverage, map_has_every_wall_triangle_with_its_numbers) {
  const LayeredSphere sphere = bare_at_first_triangle();
  const std::vector<WallLayers> walls = wall_layers(sphere.plan, sphere.surface);
  const std::string map = layer_map_vtp(walls, sphere.plan, sphere.surface);
  const std::string count = std::to_string(walls.size());
  EXPECT_THAT(map, HasSubstr("<!-- reason 3: no room -->"));
  EXPECT_THAT(map, HasSubstr("NumberOfPoints=\"" + std::to_string(sphere.plan.lines.size())));
  EXPECT_THAT(map, HasSubstr("NumberOfPolys=\"" + count + '"'));
  EXPECT_THAT(map, HasSubstr("Name=\"layers\" format=\"ascii\">\n0\n"));
  EXPECT_THAT(map, HasSubstr("Name=\"because_of\" format=\"ascii\">\n17\n"));
  EXPECT_THAT(map, HasSubstr("Name=\"first_wanted\" format=\"ascii\">\n0.01\n"));
  EXPECT_THAT(map, HasSubstr("Name=\"first_height\" format=\"ascii\">\n0\n"));
}

}  // namespace
}  // namespace tetfarm
