#include "mesh/layers/layer_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "mesh/layers/layer_proof.h"
#include "mesh/layers/wall_planes.h"
#include "tests/mesh/layers/layered_bodies.h"
#include "tests/mesh/layers/layered_surfaces.h"
#include "tests/support/generated_surfaces.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

LayerPlan plan_of(const SurfaceMesh& surface, const LayerRequest& request) {
  return plan_layers(surface, std::span(&request, 1));
}

TEST(LayerPlan, in_a_sphere_every_triangle_has_all_layers_and_lines_run_to_the_centre) {
  const SurfaceMesh sphere = shapes::sphere({0, 0, 0}, 1, 3);
  const LayerPlan plan = plan_of(sphere, test::request_of_all(sphere, 1e-3, 15));
  const test::LayerFigures figures = test::expect_valid_layers(plan, sphere);
  EXPECT_EQ(figures.full, std::ssize(sphere.triangles));
  EXPECT_EQ(figures.prisms, 15 * std::ssize(sphere.triangles));
  EXPECT_EQ(figures.pyramids + figures.tets, 0);
  for (const LayerLine& line : plan.lines) {
    EXPECT_GT(dot(normalized(line.along), -normalized(line.at)), 0.999);
  }
}

TEST(LayerPlan, in_a_cube_the_first_height_is_kept_at_edges_and_corners) {
  const SurfaceMesh cube = shapes::box({0, 0, 0}, {1, 1, 1}, 8);
  const LayerPlan plan = plan_of(cube, test::request_of_all(cube, 1e-3, 10));
  const test::LayerFigures figures = test::expect_valid_layers(plan, cube);
  EXPECT_EQ(figures.full, std::ssize(cube.triangles));
  for (const LayerLine& line : plan.lines) {
    const Vec3 p = point_of(line, 1);
    double nearest = 1;
    for (int axis = 0; axis < 3; ++axis) {
      nearest = std::min({nearest, p[axis], 1 - p[axis]});
    }
    EXPECT_NEAR(nearest, 1e-3, 1e-15);
  }
}

TEST(LayerPlan, without_a_count_layers_grow_until_they_are_as_high_as_the_edges_are_long) {
  const SurfaceMesh spheres = shapes::nested_spheres(3);
  LayerRequest request = test::request_of_all(spheres, 1e-3, 0);
  const LayerPlan plan = plan_of(spheres, request);
  EXPECT_GT(test::expect_valid_layers(plan, spheres).full, 0);
  for (const LayerLine& line : plan.lines) {
    EXPECT_GE(line.wanted, 10);
    EXPECT_LE(line.wanted, 40);
  }
}

/// Two parallel walls that are nearer than the layers of both are high.
SurfaceMesh slit(double height) { return shapes::box({0, 0, 0}, {1, 1, height}, 10); }

TEST(LayerPlan, in_a_slit_layers_keep_their_first_height_and_grow_less) {
  const SurfaceMesh surface = slit(0.02);
  const LayerPlan plan = plan_of(surface, test::request_of_all(surface, 5e-4, 10));
  test::expect_valid_layers(plan, surface);
  for (const LayerLine& line : plan.lines) {
    EXPECT_EQ(line.law.first, 5e-4);
    EXPECT_LE(point_of(line, line.stop).z, 0.02 * 0.4 + 1e-12 + (line.at.z > 0 ? 0.02 : 0));
  }
}

TEST(LayerPlan, room_stop_keeps_the_growth_and_room_scale_the_number_of_layers) {
  const SurfaceMesh surface = slit(0.02);
  LayerRequest request = test::request_of_all(surface, 5e-4, 12);
  request.room = RoomRule::stop;
  const LayerPlan stopped = plan_of(surface, request);
  test::expect_valid_layers(stopped, surface);
  request.room = RoomRule::scale;
  const LayerPlan scaled = plan_of(surface, request);
  test::expect_valid_layers(scaled, surface);
  bool is_some_stopped = false;
  bool is_some_scaled = false;
  for (std::size_t i = 0; i < stopped.lines.size(); ++i) {
    EXPECT_EQ(stopped.lines[i].law, request.law);
    is_some_stopped = is_some_stopped || stopped.lines[i].stop < 12;
    EXPECT_EQ(scaled.lines[i].law.growth, request.law.growth);
    is_some_scaled = is_some_scaled || scaled.lines[i].law.first < 4e-4;
  }
  EXPECT_TRUE(is_some_stopped);
  EXPECT_TRUE(is_some_scaled);
}

TEST(LayerPlan, with_listed_heights_gives_way_to_the_room_as_with_the_law_that_they_follow) {
  const SurfaceMesh surface = slit(0.02);
  LayerRequest by_law = test::request_of_all(surface, 0x1p-11, 10);
  by_law.law.growth = by_law.law.cap = 1.25;
  LayerRequest listed = by_law;
  std::vector<double> heights = {0x1p-11};
  while (heights.size() < 10) heights.push_back(1.25 * heights.back());  // exactly
  listed.law = law_of_heights(heights);
  for (const RoomRule room : {RoomRule::ratio, RoomRule::stop, RoomRule::scale}) {
    by_law.room = listed.room = room;
    const LayerPlan expected = plan_of(surface, by_law);
    const LayerPlan plan = plan_of(surface, listed);
    test::expect_valid_layers(plan, surface);
    ASSERT_EQ(plan.lines.size(), expected.lines.size());
    bool is_any_short = false;
    for (std::size_t i = 0; i < plan.lines.size(); ++i) {
      EXPECT_EQ(points_of(plan.lines[i]), points_of(expected.lines[i]));
      is_any_short = is_any_short || !(plan.lines[i].law == listed.law) || plan.lines[i].stop < 10;
    }
    EXPECT_TRUE(is_any_short);
  }
}

/// Where solids touch along an edge, the way from a node of the one soon ends in the other.
TEST(LayerPlan, where_there_is_hardly_any_room_scaling_makes_thin_layers) {
  const auto generators = shapes::surface_generators();
  const auto voxels = std::find_if(generators.begin(), generators.end(), [](const auto& generator) {
    return std::string_view(generator.name) == "voxels";
  });
  ASSERT_NE(voxels, generators.end());
  int thin = 0;
  for (std::uint64_t seed = 100; seed < 250; ++seed) {
    const CheckedSurface checked = check_surface(voxels->make(seed, 1));
    if (!checked.report.defects.empty()) continue;
    LayerRequest request =
        test::request_of_all(checked.surface, 0.3 * checked.report.median_edge, 6);
    request.room = RoomRule::scale;
    const LayerPlan plan = plan_of(checked.surface, request);
    test::expect_valid_layers(plan, checked.surface);
    for (const LayerLine& line : plan.lines) {
      thin += line.stop == 6 && line.law.first < 0.2 * request.law.first ? 1 : 0;
    }
  }
  EXPECT_GT(thin, 0);
}

TEST(LayerPlan, layers_taper_towards_a_curved_patch_without_any) {
  SurfaceMesh cube = shapes::box({0, 0, 0}, {1, 1, 1}, 8);
  cube.patch_names = {"wall", "inlet"};
  cube.patch_of_triangle.clear();
  for (const Triangle& t : cube.triangles) {
    const auto is_high = [&](std::int32_t v) { return cube.vertices[at(v)].z > 0.99; };
    cube.patch_of_triangle.push_back(is_high(t[0]) && is_high(t[1]) && is_high(t[2]) ? 1 : 0);
  }
  // A flat one would be a plane that layers run in.
  for (Vec3& p : cube.vertices) {
    if (p.z > 0.99) p.z += p.x * (1 - p.x) * p.y * (1 - p.y);
  }
  LayerRequest request = test::request_of_all(cube, 1e-3, 5);
  request.patches = {0};
  const LayerPlan plan = plan_of(cube, request);
  const test::LayerFigures figures = test::expect_valid_layers(plan, cube);
  EXPECT_GT(figures.pyramids, 0);
  EXPECT_GT(figures.tets, 0);
  for (const LayerLine& line : plan.lines) {
    const int rows = static_cast<int>(std::lround((1 - line.at.z) * 8));
    EXPECT_EQ(line.stop, std::min(rows, 5)) << "at z = " << line.at.z;
    if (line.stop == 5) continue;
    EXPECT_EQ(line.reason, StopReason::border);
    EXPECT_GT(cube.vertices[at(line.because_of)].z, 0.99);
  }
}

TEST(LayerPlan, with_larger_steps_a_line_that_stops_holds_fewer_back) {
  SurfaceMesh cube = shapes::box({0, 0, 0}, {1, 1, 1}, 8);
  cube.patch_names = {"wall", "inlet"};
  for (std::size_t t = 0; t < cube.triangles.size(); ++t) {
    const Triangle& nodes = cube.triangles[t];
    const bool is_high = std::all_of(nodes.begin(), nodes.end(),
                                     [&](std::int32_t v) { return cube.vertices[at(v)].z > 0.99; });
    cube.patch_of_triangle[t] = is_high ? 1 : 0;
  }
  for (Vec3& p : cube.vertices) {
    if (p.z > 0.99) p.z += p.x * (1 - p.x) * p.y * (1 - p.y);  // curved: no plane
  }
  LayerRequest request = test::request_of_all(cube, 1e-3, 5);
  request.patches = {0};
  const LayerPlan one = plan_of(cube, request);
  request.step = 3;
  const LayerPlan three = plan_of(cube, request);
  const std::int64_t full = test::expect_valid_layers(one, cube, 1).full;
  EXPECT_GT(test::expect_valid_layers(three, cube, 3).full, full);
  for (const LayerLine& line : three.lines) {
    const int rows = static_cast<int>(std::lround((1 - line.at.z) * 8));
    EXPECT_EQ(line.stop, std::min(3 * rows, 5)) << "at z = " << line.at.z;
  }
}

TEST(LayerPlan, lines_begin_at_the_very_bits_of_the_surface) {
  SurfaceMesh sphere = shapes::sphere({0, 0, 0}, 1, 2);
  for (Vec3& p : sphere.vertices) {
    if (p.x == 0) p.x = -0.0;
  }
  const LayerPlan plan = plan_of(sphere, test::request_of_all(sphere, 1e-3, 5));
  int negative_zeros = 0;
  for (const LayerLine& line : plan.lines) {
    const Vec3& p = sphere.vertices[at(line.foot)];
    for (const Vec3& foot : {point_of(line, 0), points_of(line).front()}) {
      EXPECT_EQ(std::signbit(foot.x), std::signbit(p.x));
      EXPECT_EQ(foot, p);
    }
    negative_zeros += p.x == 0 ? 1 : 0;
  }
  EXPECT_GT(negative_zeros, 0);
}

/// Round a concave edge lines lean towards the open, so that the layers there get higher.
TEST(LayerPlan, lines_bend_away_from_concave_edges_above_the_first_layer) {
  const SurfaceMesh cube = shapes::box({0, 0, 0}, {1, 1, 1}, 8);
  const LayerPlan plan = plan_of(cube, test::request_of_all(cube, 1e-3, 15));
  EXPECT_EQ(test::expect_valid_layers(plan, cube).full, std::ssize(cube.triangles));
  int bent = 0;
  for (const LayerLine& line : plan.lines) {
    if (line.at.z != 0 || line.at.x != 0.125 || line.at.y != 0.5) continue;
    ++bent;
    EXPECT_EQ(point_of(line, 1), (Vec3{0.125, 0.5, 1e-3}));
    const Vec3 last = point_of(line, 15) - point_of(line, 14);
    EXPECT_GT(last.x, 0.1 * last.z);
  }
  EXPECT_EQ(bent, 1);
}

/// Two pyramids of four faces, foot to foot: at the tips of all faces the best line is six times as
/// long as the layers are high.
TEST(LayerPlan, a_line_at_the_tip_of_a_needle_is_long_in_its_first_layer_alone) {
  SurfaceMesh needle;
  needle.vertices = {{0, 0, 8}, {0, 0, -8}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  for (std::int32_t i = 0; i < 4; ++i) {
    const std::int32_t a = 2 + i;
    const std::int32_t b = 2 + (i + 1) % 4;
    needle.triangles.push_back({0, a, b});
    needle.triangles.push_back({1, b, a});
  }
  const SurfaceMesh surface = test::in_a_box(needle);
  const LayerPlan plan = plan_of(surface, test::request_of({test::body_patch}, 0.002, 6));
  const test::LayerFigures figures = test::expect_valid_layers(plan, surface);
  EXPECT_EQ(figures.full, 8);
  int tips = 0;
  for (const LayerLine& line : plan.lines) {
    if (std::abs(line.at.z) < 8) continue;
    ++tips;
    const std::vector<double> levels = levels_of(line.law, line.stop);
    EXPECT_GT(distance(point_of(line, 1), line.at), 6 * levels[1]);
    for (int level = 2; level <= line.stop; ++level) {
      const auto l = static_cast<std::size_t>(level);
      EXPECT_NEAR(distance(point_of(line, level), point_of(line, level - 1)),
                  4 * (levels[l] - levels[l - 1]), 1e-12);
    }
  }
  EXPECT_EQ(tips, 2);
}

/// A check that knows nothing of the job takes the inside of such a body for a second region.
TEST(LayerPlan, is_made_round_a_body_that_touches_itself_along_an_edge) {
  const auto is_body = [](int x, int y, int) { return x / 4 == y / 4 ? 1 : 0; };
  const shapes::VoxelSurface voxels = shapes::voxel_surface({{8, 8, 4}, is_body});
  SurfaceMesh body = voxels.surface;
  for (std::size_t t = 0; t < body.triangles.size(); ++t) {
    if (voxels.sets[t][0] == 0) std::swap(body.triangles[t][1], body.triangles[t][2]);
  }
  const SurfaceMesh surface = test::in_a_box(body);
  const LayerPlan plan = plan_of(surface, test::request_of({test::body_patch}, 0.01, 4));
  EXPECT_TRUE(prove_cells(plan, surface).holds);
  EXPECT_TRUE(prove_top(plan, surface, wall_planes(surface, graph_of(plan, surface))).holds);
  EXPECT_GT(std::count_if(plan.lines.begin(), plan.lines.end(),
                          [](const LayerLine& line) { return line.stop == 4; }),
            8);
}

TEST(LayerPlan, of_two_requests_each_patch_has_its_own) {
  SurfaceMesh spheres = shapes::nested_spheres(2);
  spheres.patch_names = {"outer", "inner"};
  spheres.patch_of_triangle.clear();
  for (const Triangle& t : spheres.triangles) {
    spheres.patch_of_triangle.push_back(norm(spheres.vertices[at(t[0])]) > 0.6 ? 0 : 1);
  }
  LayerRequest outer = test::request_of_all(spheres, 1e-3, 4);
  LayerRequest inner = test::request_of_all(spheres, 2e-3, 7);
  outer.patches = {0};
  inner.patches = {1};
  const std::vector<LayerRequest> requests = {outer, inner};
  const LayerPlan plan = plan_layers(spheres, requests);
  test::expect_valid_layers(plan, spheres);
  for (const LayerLine& line : plan.lines) {
    EXPECT_EQ(line.stop, norm(line.at) > 0.6 ? 4 : 7);
    EXPECT_EQ(line.law.first, norm(line.at) > 0.6 ? 1e-3 : 2e-3);
  }
}

TEST(LayerPlan, is_a_mesh_on_every_generated_surface) {
  std::int64_t surfaces = 0;
  std::int64_t cells = 0;
  for (const shapes::SurfaceGenerator& generator : shapes::surface_generators()) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const CheckedSurface checked = check_surface(generator.make(seed, 1));
      if (!checked.report.defects.empty() || region_count(checked.surface) > 1) continue;
      const SurfaceMesh& surface = checked.surface;
      const LayerRequest request =
          test::request_of_all(surface, 0.02 * checked.report.median_edge, seed % 2 == 0 ? 8 : 0);
      SCOPED_TRACE(std::string(generator.name) + ", seed " + std::to_string(seed));
      const test::LayerFigures figures =
          test::expect_valid_layers(plan_of(surface, request), surface);
      ++surfaces;
      cells += figures.prisms + figures.pyramids + figures.tets;
    }
  }
  EXPECT_GT(surfaces, 250);
  EXPECT_GT(cells, 80'000);
}

}  // namespace
}  // namespace tetfarm
