#include "mesh/remeshing/remesh.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <random>

#include "mesh/inspect/surface_check.h"
#include "mesh/remeshing/remeshing_figures.h"
#include "tests/support/cad_families.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

struct Outcome {
  SurfaceMesh input;
  RemeshedSurface result;
  RemeshingFigures figures;
  RemeshOptions options;
};

Outcome remeshed(const SurfaceMesh& surface, RemeshOptions options) {
  Outcome outcome;
  outcome.input = check_surface(surface).surface;
  outcome.options = with_defaults(std::move(options), surface);
  const SurfaceFeatures features = surface_features(outcome.input, outcome.options.angle_deg);
  const RemeshingSpacing spacing = remeshing_spacing(outcome.input, features, outcome.options);
  outcome.result = remesh(outcome.input, features, spacing, outcome.options);
  outcome.figures = remeshing_figures(outcome.input, outcome.result, spacing);
  return outcome;
}

Outcome remeshed(const SurfaceMesh& surface, double size) {
  RemeshOptions options;
  options.size = size;
  return remeshed(surface, options);
}

std::vector<SurfaceDefect> defects_of(SurfaceMesh surface) {
  surface.sides.clear();
  surface.region_names.clear();
  return check_surface(surface).report.defects;
}

TEST(Remesh, makes_even_triangles_of_a_box_of_twelve) {
  const Outcome cube = remeshed(shapes::unit_cube(), 0.1);
  EXPECT_THAT(defects_of(cube.result.surface), ::testing::IsEmpty());
  EXPECT_NEAR(cube.figures.volume, 1, 1e-12);
  EXPECT_GE(cube.figures.smallest_angle_deg, 30);
  EXPECT_GE(cube.figures.mean_radius_ratio, 0.93);
  EXPECT_GE(cube.figures.well_sized, 0.95);
  EXPECT_NEAR(cube.figures.mean_length, 1, 0.1);
  EXPECT_LE(cube.figures.from_input.distance, 1e-12);
  EXPECT_LE(cube.figures.to_input.distance, 1e-12);
}

TEST(Remesh, keeps_corners_to_the_last_bit) {
  const SurfaceMesh box = shapes::box({0.1, 0.2, 0.3}, {1, 1.1, 0.7}, 1);
  const Outcome outcome = remeshed(box, 0.17);
  for (const Vec3& corner : box.vertices) {
    EXPECT_THAT(outcome.result.surface.vertices, ::testing::Contains(corner));
  }
}

TEST(Remesh, makes_a_fine_sphere_coarser_within_the_tolerance) {
  RemeshOptions options;
  options.size = 0.3;
  options.tolerance = 0.02;
  const Outcome sphere = remeshed(shapes::sphere({0, 0, 0}, 1, 4), options);
  EXPECT_LT(sphere.figures.triangles, sphere.figures.triangles_before / 3);
  EXPECT_THAT(defects_of(sphere.result.surface), ::testing::IsEmpty());
  EXPECT_LE(sphere.figures.from_input.distance, 0.02);
  EXPECT_LE(sphere.figures.to_input.distance, 0.03);
  EXPECT_GE(sphere.figures.smallest_angle_deg, 30);
}

TEST(Remesh, keeps_patches_and_their_areas) {
  SurfaceMesh box = shapes::box({0, 0, 0}, {1, 1, 1}, 2);
  box.patch_of_triangle.clear();
  box.patch_names = {"rest", "half"};
  const auto is_half = [](const SurfaceMesh& s, const Triangle& t) {
    double x = 0;
    for (const std::int32_t v : t) x += s.vertices[static_cast<std::size_t>(v)].x / 3;
    return x < 0.5;
  };
  for (const Triangle& t : box.triangles) box.patch_of_triangle.push_back(is_half(box, t) ? 1 : 0);
  const SurfaceMesh result = remeshed(box, 0.13).result.surface;
  EXPECT_EQ(result.patch_names, box.patch_names);
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    EXPECT_EQ(result.patch_of_triangle[t], is_half(result, result.triangles[t]) ? 1 : 0);
  }
}

TEST(Remesh, is_the_same_each_time) {
  const SurfaceMesh part = shapes::filleted_bar(1, 1);
  const Outcome first = remeshed(part, 0);
  const Outcome second = remeshed(part, 0);
  EXPECT_EQ(first.result.surface.vertices, second.result.surface.vertices);
  EXPECT_EQ(first.result.surface.triangles, second.result.surface.triangles);
}

using Family = std::function<SurfaceMesh(std::uint64_t, int)>;

TEST(Remesh, of_parts_as_cad_writes_them_is_sound_and_near) {
  const std::vector<std::pair<std::string, Family>> families = {
      {"cylinder", shapes::capped_cylinder}, {"fan", shapes::fan_node},
      {"plate", shapes::perforated_plate},   {"gear", shapes::gear},
      {"block", shapes::rounded_block},      {"bar", shapes::filleted_bar},
      {"extrusion", shapes::split_extrusion}};
  for (const auto& [name, family] : families) {
    SCOPED_TRACE(name);
    const Outcome part = remeshed(family(2, 1), 0);
    EXPECT_THAT(defects_of(part.result.surface), ::testing::IsEmpty());
    EXPECT_LE(part.figures.from_input.distance, part.options.tolerance);
    EXPECT_LE(part.figures.to_input.distance, 2 * part.options.tolerance);
    EXPECT_GE(part.figures.smallest_free_angle_deg, 15);
  }
}

}  // namespace
}  // namespace tetfarm
