#include "mesh/remeshing/remeshing_figures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

/// Squares of 0.25, each of two triangles.
SurfaceMesh measured_box() { return shapes::box({0, 0, 0}, {1, 1, 1}, 4); }

TEST(RemeshingFigures, of_a_surface_and_itself_show_no_distance) {
  const SurfaceMesh box = measured_box();
  const RemeshingFigures f = remeshing_figures(box, {box, {}}, RemeshingSpacing(0.25));
  EXPECT_EQ(f.triangles, 6 * 4 * 4 * 2);
  EXPECT_EQ(f.triangles_before, f.triangles);
  EXPECT_EQ(f.vertices, 6 * 4 * 4 + 2);
  EXPECT_NEAR(f.from_input.distance, 0, 1e-14);
  EXPECT_NEAR(f.to_input.distance, 0, 1e-14);
  EXPECT_NEAR(f.volume, 1, 1e-14);
  EXPECT_EQ(f.volume, f.volume_before);
}

TEST(RemeshingFigures, of_half_squares_are_known) {
  const SurfaceMesh box = measured_box();
  const RemeshingFigures f = remeshing_figures(box, {box, {}}, RemeshingSpacing(0.25));
  EXPECT_NEAR(f.smallest_angle_deg, 45, 1e-9);
  EXPECT_EQ(f.below_30_deg, 0);
  EXPECT_NEAR(f.mean_radius_ratio, 2 * std::sqrt(2.0) - 2, 1e-12);
  EXPECT_NEAR(f.mean_length, (2 + std::sqrt(2.0)) / 3, 1e-12);
  EXPECT_EQ(f.well_sized, 1);
}

TEST(RemeshingFigures, count_edges_that_are_too_short_for_the_spacing) {
  const SurfaceMesh box = measured_box();
  const RemeshingFigures f = remeshing_figures(box, {box, {}}, RemeshingSpacing(0.5));
  EXPECT_NEAR(f.mean_length, (2 + std::sqrt(2.0)) / 6, 1e-12);
  EXPECT_NEAR(f.well_sized, 1.0 / 3, 1e-12);  // the diagonals
}

TEST(RemeshingFigures, take_triangles_at_a_feature_for_none_that_are_free) {
  const SurfaceMesh box = measured_box();
  const Triangle& first = box.triangles.front();
  const RemeshedSurface result{box, {{first[0], first[1]}}};
  const RemeshingFigures f = remeshing_figures(box, result, RemeshingSpacing(0.25));
  EXPECT_EQ(remeshing_figures(box, {box, {}}, RemeshingSpacing(0.25)).free_triangles, f.triangles);
  EXPECT_LT(f.free_triangles, f.triangles);
  EXPECT_GT(f.free_triangles, 0);
}

TEST(RemeshingFigures, tell_how_far_a_dent_is_and_where) {
  const SurfaceMesh box = measured_box();
  RemeshedSurface dented{box, {}};
  for (Vec3& v : dented.surface.vertices) {
    if (v == Vec3{0.5, 0.5, 1}) v.z = 0.99;
  }
  const RemeshingFigures f = remeshing_figures(box, dented, RemeshingSpacing(0.25));
  EXPECT_NEAR(f.from_input.distance, 0.01, 1e-12);
  EXPECT_EQ(f.from_input.at, (Vec3{0.5, 0.5, 0.99}));
  EXPECT_NEAR(f.to_input.distance, 0.01, 1e-3);
  EXPECT_LT(f.volume, f.volume_before);
}

}  // namespace
}  // namespace tetfarm
