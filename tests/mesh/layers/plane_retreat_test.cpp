#include "mesh/layers/plane_retreat.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "mesh/core/triangle_angles.h"
#include "tests/mesh/layers/boxes_with_planes.h"
#include "tests/mesh/layers/layered_box.h"
#include "tests/mesh/layers/layered_surfaces.h"
#include "tests/support/generated_surfaces.h"

namespace tetfarm {
namespace {

/// Everywhere the same.
MakePlaneSpacing spacing_of(double size) {
  return [size](const SurfaceMesh&) { return [size](const Vec3&) { return size; }; };
}

LayerPlan plan_of(const SurfaceMesh& surface, const LayerRequest& request) {
  return plan_layers(surface, std::span(&request, 1));
}

/// The area of each patch, quads of sides included.
std::map<std::int32_t, double> areas_of(const SurfaceMesh& surface, const LayerPlan& plan) {
  const auto area = [](const Vec3& a, const Vec3& b, const Vec3& c) {
    return norm(cross(b - a, c - a)) / 2;
  };
  std::map<std::int32_t, double> areas;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    areas[surface.patch_of_triangle[t]] +=
        area(surface.vertices[at(a)], surface.vertices[at(b)], surface.vertices[at(c)]);
  }
  for (const LayerSide& side : plan.sides) {
    const Triangle& nodes = surface.triangles[at(side.triangle)];
    const LayerLine& from = plan.lines[at(plan.vertex2line[at(nodes[at(side.corner)])])];
    const LayerLine& to = plan.lines[at(plan.vertex2line[at(nodes[at((side.corner + 1) % 3)])])];
    const std::vector<Vec3> a = points_of(from);
    const std::vector<Vec3> b = points_of(to);
    for (std::size_t i = 1; i <= at(quads_of({from, to})); ++i) {
      areas[side.patch] += area(a[i - 1], b[i - 1], b[i]) + area(a[i - 1], b[i], a[i]);
    }
  }
  return areas;
}

void expect_unit_box(const SurfaceMesh& box, const LayerRequest& request) {
  const LayerPlan plan = plan_of(box, request);
  const auto retreat = retreat_planes(box, plan, spacing_of(0.125));
  ASSERT_TRUE(retreat.has_value());
  const test::LayerFigures figures = test::expect_valid_layers(retreat->plan, retreat->surface);
  EXPECT_EQ(figures.full, std::ssize(plan.wall));
  for (const auto& [patch, area] : areas_of(retreat->surface, retreat->plan)) {
    EXPECT_NEAR(area, 1, 1e-12) << box.patch_names[at(patch)];
  }
}

TEST(PlaneRetreat, over_the_floor_of_a_box_all_layers_reach_its_four_sides) {
  const SurfaceMesh box = test::box_with_patches({0, 0, 0}, {1, 1, 1}, 8);
  const LayerRequest request = test::request_of({test::floor_patch}, 0.01, 12);
  expect_unit_box(box, request);
  const LayerPlan plan = plan_of(box, request);
  const auto retreat = retreat_planes(box, plan, spacing_of(0.125));
  EXPECT_EQ(retreat->figures.planes, 4);
  EXPECT_EQ(retreat->figures.quads, 4 * 8 * 12);
  EXPECT_EQ(retreat->figures.side_triangles, 0);
  EXPECT_EQ(retreat->figures.triangles_before, 4 * 128);
  EXPECT_GT(retreat->figures.triangles_after, 4 * 60);
}

TEST(PlaneRetreat, a_box_that_lies_aslant_is_like_one_that_does_not) {
  expect_unit_box(test::turned(test::box_with_patches({0, 0, 0}, {1, 1, 1}, 8)),
                  test::request_of({test::floor_patch}, 0.01, 12));
}

TEST(PlaneRetreat, between_floor_and_ceiling_sides_are_bounded_by_layers_of_both) {
  expect_unit_box(test::box_with_patches({0, 0, 0}, {1, 1, 1}, 8),
                  test::request_of({test::floor_patch, test::ceiling_patch}, 0.01, 8));
}

TEST(PlaneRetreat, along_an_edge_between_two_walls_lines_stay_in_the_plane_at_its_ends) {
  const SurfaceMesh box = test::box_with_patches({0, 0, 0}, {1, 1, 1}, 8);
  expect_unit_box(box, test::request_of({test::floor_patch, 2}, 0.01, 8));  // west
}

TEST(PlaneRetreat, points_of_a_plane_have_its_coordinate_to_the_last_bit) {
  const SurfaceMesh box = test::box_with_patches({0.1, 0.2, 0.3}, {1.1, 1.2, 1.3}, 8);
  const LayerPlan plan = plan_of(box, test::request_of({test::floor_patch}, 0.01, 12));
  const auto retreat = retreat_planes(box, plan, spacing_of(0.125));
  ASSERT_TRUE(retreat.has_value());
  std::int64_t looked = 0;
  for (std::size_t t = 0; t < retreat->surface.triangles.size(); ++t) {
    if (retreat->surface.patch_of_triangle[t] != 3) continue;
    for (const std::int32_t v : retreat->surface.triangles[t]) {
      EXPECT_EQ(retreat->surface.vertices[at(v)].x, 1.1);
      ++looked;
    }
  }
  EXPECT_GT(looked, 100);
}

TEST(PlaneRetreat, where_stops_differ_triangles_end_the_quads) {
  for (const int step : {1, 3}) {
    const test::LayeredBox box(step);
    test::expect_valid_layers(box.plan, box.surface, step);
    int largest = 0;
    for (const LayerSide& side : box.plan.sides) {
      const Triangle& nodes = box.surface.triangles[at(side.triangle)];
      const auto stop = [&](int corner) {
        return box.plan.lines[at(box.plan.vertex2line[at(nodes[at(corner % 3)])])].stop;
      };
      EXPECT_EQ(side.last >= 0, stop(side.corner) != stop(side.corner + 1));
      largest = std::max(largest, std::abs(stop(side.corner) - stop(side.corner + 1)));
    }
    EXPECT_EQ(largest, step);
    const auto areas = areas_of(box.surface, box.plan);
    EXPECT_NEAR(areas.at(4), 1, 1e-12);
    EXPECT_NEAR(areas.at(5), 1, 1e-12);
  }
}

TEST(PlaneRetreat, beside_layers_in_tets_all_points_of_lines_are_vertices_and_quads_are_triangles) {
  for (const int step : {1, 3}) {
    const test::LayeredBox box(step, true);
    const test::LayeredBox quads(step);
    test::expect_valid_layers(box.plan, box.surface, step);
    ASSERT_EQ(box.plan.lines.size(), quads.plan.lines.size());
    for (std::size_t i = 0; i < box.plan.lines.size(); ++i) {
      const LayerLine& line = box.plan.lines[i];
      EXPECT_EQ(points_of(line), points_of(quads.plan.lines[i]));
      EXPECT_EQ(line.vertices, quads.plan.lines[i].vertices > 0 ? line.stop : 0);
      for (int level = 0; level <= line.stop && line.vertices > 0; ++level) {
        EXPECT_EQ(box.surface.vertices.at(at(vertex_at(line, level))), point_of(line, level));
      }
    }
    const auto areas = areas_of(box.surface, box.plan);
    EXPECT_NEAR(areas.at(4), 1, 1e-12);
    EXPECT_NEAR(areas.at(5), 1, 1e-12);
  }
}

TEST(PlaneRetreat, tells_that_layers_in_tets_have_triangles_for_sides) {
  const SurfaceMesh box = test::box_with_patches({0, 0, 0}, {1, 1, 1}, 8);
  LayerRequest request = test::request_of({test::floor_patch}, 0.01, 12);
  const auto quads = retreat_planes(box, plan_of(box, request), spacing_of(0.125));
  request.in_tets = true;
  const auto retreat = retreat_planes(box, plan_of(box, request), spacing_of(0.125));
  EXPECT_EQ(retreat->figures.quads, 0);
  EXPECT_EQ(retreat->figures.side_triangles, 2 * 4 * 8 * 12);
  EXPECT_EQ(retreat->figures.triangles_after, quads->figures.triangles_after);
}

TEST(PlaneRetreat, a_surface_that_is_all_wall_has_no_planes) {
  const SurfaceMesh box = test::box_with_patches({0, 0, 0}, {1, 1, 1}, 4);
  const LayerPlan plan = plan_of(box, test::request_of_all(box, 0.01, 3));
  EXPECT_FALSE(retreat_planes(box, plan, spacing_of(0.125)).has_value());
}

TEST(PlaneRetreat, layers_that_would_fill_a_plane_leave_some_of_it) {
  // Two walls that are nearer than both their layers are high.
  const SurfaceMesh slit = test::box_with_patches({0, 0, 0}, {1, 1, 0.05}, 8);
  const LayerPlan plan =
      plan_of(slit, test::request_of({test::floor_patch, test::ceiling_patch}, 0.005, 12));
  const auto retreat = retreat_planes(slit, plan, spacing_of(0.125));
  ASSERT_TRUE(retreat.has_value());
  test::expect_valid_layers(retreat->plan, retreat->surface);
  EXPECT_GT(retreat->figures.triangles_after, 0);
}

TEST(PlaneRetreat, leaves_a_mesh_beside_flat_patches_of_every_generated_surface) {
  std::int64_t with_planes = 0;
  std::int64_t steep = 0;
  for (const shapes::SurfaceGenerator& generator : shapes::surface_generators()) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      SCOPED_TRACE(std::string(generator.name) + ", seed " + std::to_string(seed));
      const CheckedSurface checked =
          check_surface(test::with_flat_patches(generator.make(seed, 1), seed));
      if (!checked.report.defects.empty() || region_count(checked.surface) > 1) continue;
      const double size = checked.report.median_edge;
      LayerRequest request = test::request_of({0}, (seed % 2 == 0 ? 0.02 : 0.2) * size, 5);
      request.step = seed % 4 < 2 ? 1 : 4;
      const LayerPlan plan = plan_of(checked.surface, request);
      const auto retreat = retreat_planes(checked.surface, plan, spacing_of(size));
      if (!retreat) continue;
      test::expect_valid_layers(retreat->plan, retreat->surface, request.step);
      steep += std::any_of(retreat->plan.lines.begin(), retreat->plan.lines.end(),
                           [](const LayerLine& line) { return line.vertices > 2; });
      ++with_planes;
    }
  }
  EXPECT_GT(with_planes, 30);
  EXPECT_GT(steep, 0);
}

}  // namespace
}  // namespace tetfarm
