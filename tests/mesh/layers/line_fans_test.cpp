// Several lines at sharp convex edges and corners: which feet have them, and that the layers are a
// mesh then.
#include "mesh/layers/line_fans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "base/array_index.h"
#include "tests/mesh/layers/layered_bodies.h"
#include "tests/mesh/layers/layered_surfaces.h"

namespace tetfarm {
namespace {

std::map<std::size_t, int> feet_by_lines(const LayerPlan& plan) {
  std::map<std::int32_t, std::size_t> lines;
  for (const LayerLine& line : plan.lines) ++lines[line.foot];
  std::map<std::size_t, int> feet;
  for (const auto& [foot, count] : lines) ++feet[count];
  return feet;
}

LayerPlan plan_of(const SurfaceMesh& surface, const LayerRequest& request) {
  const CheckedSurface checked = check_surface(surface);
  EXPECT_TRUE(checked.report.defects.empty());
  EXPECT_EQ(checked.surface.triangles, surface.triangles) << "turned";
  return plan_layers(surface, {&request, 1});
}

TEST(LineFans, go_round_the_edges_and_corners_of_a_cube) {
  const SurfaceMesh surface = test::cube_in_box(4);
  const LayerPlan plan = plan_of(surface, test::fanned(0.02, 6, 60));
  const test::LayerFigures figures = test::expect_valid_layers(plan, surface);
  EXPECT_EQ(figures.full, std::ssize(plan.wall));
  // Two pieces a right angle: three lines at an edge, six at a corner.
  const std::map<std::size_t, int> expected = {{1, 6 * 9}, {3, 12 * 3}, {6, 8}};
  EXPECT_EQ(feet_by_lines(plan), expected);
}

TEST(LineFans, go_round_the_sharp_edges_of_a_lens) {
  for (const double degrees : {60.0, 20.0, 5.0}) {
    const SurfaceMesh surface = test::lens_in_box(8, degrees, degrees);
    const LayerPlan plan = plan_of(surface, test::fanned(0.002, 10, 60));
    const test::LayerFigures figures = test::expect_valid_layers(plan, surface);
    EXPECT_EQ(figures.full, std::ssize(plan.wall)) << degrees;
    // One group above, one below; as many pieces as are at most 60 degrees wide, by halving.
    const std::size_t lines = degrees == 60 ? 3 : 5;
    EXPECT_GT(feet_by_lines(plan).at(lines), 2 * 7) << degrees;
  }
}

/// From 70 degrees within the body, so that faces turn by 110, to 150, so that they turn by 30.
TEST(LineFans, end_where_an_edge_is_no_longer_sharp_and_are_early_there) {
  const SurfaceMesh surface = test::lens_in_box(12, 70, 150);
  const LayerPlan plan = plan_of(surface, test::fanned(0.01, 6, 60));
  const test::LayerFigures figures = test::expect_valid_layers(plan, surface);
  EXPECT_EQ(figures.full, std::ssize(plan.wall));
  std::int64_t early = 0;
  for (const FanPiece& piece : plan.fans) {
    const bool ends = plan.lines[at(piece.to[0])].foot != plan.lines[at(piece.from[0])].foot &&
                      piece.to[0] == piece.to[1];
    EXPECT_TRUE(!ends || plan.lines[at(piece.from[0])].early);
    early += ends ? 1 : 0;
  }
  EXPECT_GT(early, 0);
}

TEST(LineFans, are_where_edges_turn_by_more_than_the_angle_and_are_convex) {
  const SurfaceMesh surface = test::cube_in_box(4);
  EXPECT_TRUE(plan_of(surface, test::fanned(0.02, 6, 95)).fans.empty());
  EXPECT_FALSE(plan_of(surface, test::fanned(0.02, 6, 85)).fans.empty());
  EXPECT_TRUE(plan_of(surface, test::request_of({test::body_patch}, 0.02, 6)).fans.empty());
  LayerRequest inside = test::fanned(0.02, 6, 60);
  inside.patches = {1};  // the box, whose edges are concave
  EXPECT_TRUE(plan_of(surface, inside).fans.empty());
}

TEST(LineFans, have_no_part_in_lines_beside_two_patches) {
  SurfaceMesh pillar = test::pillar_in_box();
  pillar.patch_names.emplace_back("half of the floor");
  for (std::size_t t = 0; t < pillar.triangles.size(); ++t) {
    double x = 0;
    for (const std::int32_t v : pillar.triangles[t]) x += pillar.vertices[at(v)].x / 3;
    if (pillar.patch_of_triangle[t] == 1 && x > 4) pillar.patch_of_triangle[t] = 3;
  }
  const LayerPlan plan = plan_of(pillar, test::fanned(0.02, 5, 60));
  EXPECT_FALSE(plan.fans.empty());
  for (std::size_t i = 1; i < plan.lines.size(); ++i) {
    const bool is_of_fan = plan.lines[i].foot == plan.lines[i - 1].foot;
    EXPECT_FALSE(is_of_fan && plan.lines[i].at.z == 0 && plan.lines[i].at.x == 4);
  }
}

TEST(LineFans, run_in_planes_beside_the_wall) {
  const test::LayeredPillar pillar;
  const test::LayerFigures figures = test::expect_valid_layers(pillar.plan, pillar.surface);
  EXPECT_EQ(figures.full, std::ssize(pillar.plan.wall));
  std::map<std::int32_t, int> lines_at_floor;
  for (const LayerLine& line : pillar.plan.lines) {
    EXPECT_FALSE(line.early) << "no fan ends";
    if (line.at.z != 0) continue;
    ++lines_at_floor[line.foot];
    EXPECT_EQ(line.along.z, 0);
    EXPECT_EQ(point_of(line, line.stop).z, 0);
  }
  EXPECT_EQ(std::count_if(lines_at_floor.begin(), lines_at_floor.end(),
                          [](const auto& foot) { return foot.second == 3; }),
            4);
  std::int64_t ends = 0;
  for (const FanPiece& piece : pillar.plan.fans) {
    for (const FanEnd& end : piece.ends) ends += end.patch == 1 ? 1 : 0;
  }
  EXPECT_EQ(ends, 4 * 2);
}

/// A fin of two faces that meet at 4 degrees stands on a block: at its root the edge ends between
/// faces that look apart, and no single direction sees them all.
TEST(LineFans, go_on_at_the_root_of_a_fin) {
  const SurfaceMesh surface = test::fin_in_box();
  const LayerPlan single = plan_of(surface, test::request_of({test::body_patch}, 0.004, 5));
  const LayerPlan fanned = plan_of(surface, test::fanned(0.004, 5, 60));
  const test::LayerFigures before = test::expect_valid_layers(single, surface);
  const test::LayerFigures after = test::expect_valid_layers(fanned, surface);
  EXPECT_LT(before.full, std::ssize(single.wall));
  EXPECT_EQ(after.full, std::ssize(fanned.wall));
}

}  // namespace
}  // namespace tetfarm
