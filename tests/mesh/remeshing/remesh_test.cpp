#include "mesh/remeshing/remesh.h"

#include <gmock/gmock.h>

#include "tests/mesh/remeshing/remesh_outcome.h"
#include "tests/support/cad_families.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

TEST(Remesh, makes_even_triangles_of_a_box_of_twelve) {
  const RemeshOutcome cube = remesh_outcome(shapes::unit_cube(), 0.1);
  EXPECT_THAT(defects_of_remeshed(cube.result.surface), ::testing::IsEmpty());
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
  const RemeshOutcome outcome = remesh_outcome(box, 0.17);
  for (const Vec3& corner : box.vertices) {
    EXPECT_THAT(outcome.result.surface.vertices, ::testing::Contains(corner));
  }
}

TEST(Remesh, makes_a_fine_sphere_coarser_within_the_tolerance) {
  RemeshOptions options;
  options.size = 0.3;
  options.tolerance = 0.02;
  const RemeshOutcome sphere = remesh_outcome(shapes::sphere({0, 0, 0}, 1, 4), options);
  EXPECT_LT(sphere.figures.triangles, sphere.figures.triangles_before / 3);
  EXPECT_THAT(defects_of_remeshed(sphere.result.surface), ::testing::IsEmpty());
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
  const SurfaceMesh result = remesh_outcome(box, 0.13).result.surface;
  EXPECT_EQ(result.patch_names, box.patch_names);
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    EXPECT_EQ(result.patch_of_triangle[t], is_half(result, result.triangles[t]) ? 1 : 0);
  }
}

TEST(Remesh, is_the_same_each_time) {
  const SurfaceMesh part = shapes::filleted_bar(1, 1);
  const RemeshOutcome first = remesh_outcome(part, coarse_options(part));
  const RemeshOutcome second = remesh_outcome(part, coarse_options(part));
  EXPECT_EQ(first.result.surface.vertices, second.result.surface.vertices);
  EXPECT_EQ(first.result.surface.triangles, second.result.surface.triangles);
}

}  // namespace
}  // namespace tetfarm
