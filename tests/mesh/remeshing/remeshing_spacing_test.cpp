#include "mesh/remeshing/remeshing_spacing.h"

#include <gmock/gmock.h>

#include "mesh/remeshing/curvature_demands.h"
#include "mesh/remeshing/proximity_demands.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

RemeshingSpacing spacing_of(const SurfaceMesh& surface, double size, double min_size) {
  RemeshOptions options;
  options.size = size;
  options.min_size = min_size;
  options = with_defaults(options, surface);
  return remeshing_spacing(surface, surface_features(surface, 30), options);
}

TEST(RemeshingSpacing, of_a_large_plane_is_the_size_asked_for) {
  const RemeshingSpacing spacing = spacing_of(shapes::unit_cube(), 0.1, 0.01);
  EXPECT_EQ(spacing.at({0.5, 0.5, 1}), 0.1);
  EXPECT_EQ(spacing.at({0, 0, 0}), 0.1);
}

TEST(RemeshingSpacing, is_what_a_patch_asks_for_also_below_the_least_size) {
  const SurfaceMesh cube = shapes::unit_cube();
  RemeshOptions options;
  options.size = 0.1;
  options.min_size = 0.05;
  options.triangles = {{{Vec3{0, 0, 1}, Vec3{1, 0, 1}, Vec3{0, 1, 1}}, 0.01, 0.2}};
  options = with_defaults(options, cube);
  const RemeshingSpacing spacing = remeshing_spacing(cube, surface_features(cube, 30), options);
  EXPECT_EQ(spacing.at({0.25, 0.25, 1}), 0.01);
  EXPECT_NEAR(spacing.at({0.25, 0.25, 1.106}), 0.03, 1e-15);
  EXPECT_EQ(spacing.at({0.25, 0.25, 0}), 0.1);
}

TEST(RemeshingSpacing, follows_the_radius_of_a_sphere) {
  const SurfaceMesh sphere = shapes::sphere({0, 0, 0}, 1, 3);
  RemeshOptions options;
  options.size = 1;
  options.min_size = 0.01;
  options.tolerance = 0.002;
  options = with_defaults(options, sphere);
  const RemeshingSpacing spacing = remeshing_spacing(sphere, surface_features(sphere, 30), options);
  // sqrt(8 r T): a chord as far off the sphere as the tolerance; the radius is the triangles'
  // guess.
  EXPECT_NEAR(spacing.at({1, 0, 0}), std::sqrt(8 * 0.002), 0.06);
}

TEST(RemeshingSpacing, puts_three_edges_across_a_thin_plate) {
  const SurfaceMesh plate = shapes::box({0, 0, 0}, {10, 10, 0.3}, 5);
  const RemeshingSpacing spacing = spacing_of(plate, 1, 0.01);
  for (double x = 0.5; x < 9.6; x += 0.35) {
    EXPECT_NEAR(spacing.at({x, 0.7 * x + 1, 0.3}), 0.1, 0.02) << x;
  }
  // No finer than the least size, however thin.
  EXPECT_NEAR(spacing_of(plate, 1, 0.25).at({5, 5, 0.3}), 0.25, 1e-12);
}

TEST(RemeshingSpacing, does_not_flood_a_wedge) {
  SurfaceMesh wedge = shapes::box({0, 0, 0}, {10, 10, 1}, 5);
  for (Vec3& v : wedge.vertices) v.z *= 1 + 0.4 * v.x;
  const RemeshingSpacing spacing = spacing_of(wedge, 0.5, 0.01);
  EXPECT_EQ(spacing.at({5, 5, 0}), 0.5);
}

TEST(RemeshingSpacing, resolves_a_short_edge_between_two_corners) {
  const SurfaceMesh bar = shapes::box({0, 0, 0}, {1, 1, 0.02}, 1);
  EXPECT_NEAR(spacing_of(bar, 0.5, 0.2).at({0, 0, 0.01}), 0.02, 1e-12);
}

TEST(RemeshingSpacing, has_an_end_towards_an_edge_of_nearly_nothing) {
  const RemeshingSpacing spacing = spacing_of(shapes::box({0, 0, 0}, {1, 1, 1e-3}, 1), 0.5, 0.1);
  EXPECT_NEAR(spacing.at({0, 0, 0}), 0.1 / 16, 1e-9);
}

TEST(RemeshingSpacing, grows_by_no_more_than_the_growth) {
  const SurfaceMesh bar = shapes::box({0, 0, 0}, {1, 1, 0.02}, 1);
  const RemeshingSpacing spacing = spacing_of(bar, 0.5, 0.2);
  for (double x = 0; x < 1; x += 0.05) {
    const double rise = spacing.at({x + 0.05, 0.5, 0}) - spacing.at({x, 0.5, 0});
    EXPECT_LE(std::abs(rise), 0.3 * 0.05 + 1e-12);
  }
}

TEST(RemeshingSpacing, is_that_of_a_source_within_it) {
  RemeshOptions options;
  options.size = 1;
  options.min_size = 0.01;
  options.sources = {Source{{SourceCorner{{0.5, 0.5, 1}, 0.05, 0.2, 0.4}}}};
  const SurfaceMesh cube = shapes::unit_cube();
  options = with_defaults(options, cube);
  const RemeshingSpacing spacing = remeshing_spacing(cube, surface_features(cube, 30), options);
  EXPECT_NEAR(spacing.at({0.5, 0.6, 1}), 0.05, 1e-12);
}

}  // namespace
}  // namespace tetfarm
