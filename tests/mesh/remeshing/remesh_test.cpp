#include "mesh/remeshing/remesh.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "mesh/geometry/triangle_intersection.h"
#include "mesh/inspect/surface_edges.h"
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

/// The most that the normals of two triangles differ by, as a cosine, over edges that are no
/// feature.
double least_cosine_between_neighbours(const RemeshedSurface& result) {
  const SurfaceMesh& surface = result.surface;
  const auto normal = [&surface](std::int32_t t) {
    const TrianglePoints c =
        triangle_points(surface.vertices, surface.triangles[static_cast<std::size_t>(t)]);
    return normalized(cross(c[1] - c[0], c[2] - c[0]));
  };
  double least = 1;
  const std::vector<EdgeUse> uses = edge_uses(surface.triangles);
  for_each_edge(std::span<const EdgeUse>(uses), [&](std::span<const EdgeUse> edge) {
    const std::array<std::int32_t, 2> ends{edge[0].low, edge[0].high};
    if (std::ranges::binary_search(result.feature_edges, ends)) return;
    least = std::min(least, dot(normal(edge[0].triangle), normal(edge[1].triangle)));
  });
  return least;
}

TEST(Remesh, folds_nothing_over_where_walls_are_nearer_than_the_tolerance) {
  // Like a wing: round at one end, and sharp at the other, where both sides of one face meet.
  SurfaceMesh wing = shapes::sphere({0, 0, 0}, 1, 3);
  for (Vec3& v : wing.vertices) {
    v.z *= 0.01 + 0.49 * std::clamp((0.3 - v.x) / 1.3, 0.0, 1.0);
    v.x *= 2;
  }
  RemeshOptions options;
  options.size = 0.2;
  options.min_size = 0.2;
  options.tolerance = 0.2;
  const RemeshOutcome even = remesh_outcome(wing, options);
  EXPECT_THAT(defects_of_remeshed(even.result.surface), ::testing::IsEmpty());
  EXPECT_GT(least_cosine_between_neighbours(even.result), -0.5) << "-1 is a fold";
}

}  // namespace
}  // namespace tetfarm
