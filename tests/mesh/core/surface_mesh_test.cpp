#include "mesh/core/surface_mesh.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

double volume_of(const SurfaceMesh& mesh) { return enclosed_volume(mesh.vertices, mesh.triangles); }

TEST(EnclosedVolume, is_that_of_known_shapes) {
  EXPECT_NEAR(volume_of(shapes::unit_cube()), 1, 1e-15);
  EXPECT_NEAR(volume_of(shapes::tetrahedron()), 1.0 / 6, 1e-16);
  EXPECT_NEAR(volume_of(shapes::box({-1, 2, 3}, {1, 5, 4}, 3)), 6, 1e-14);
  EXPECT_NEAR(volume_of(shapes::sphere({5, 0, 0}, 1, 4)), 4.0 / 3 * std::numbers::pi, 0.02);
}

TEST(EnclosedVolume, of_a_cavity_is_subtracted) {
  const SurfaceMesh cube = shapes::box({0, 0, 0}, {3, 3, 3}, 1);
  const SurfaceMesh hole = shapes::box({1, 1, 1}, {2, 2, 2}, 1);
  EXPECT_NEAR(volume_of(shapes::between(cube, hole)), 26, 1e-13);
}

TEST(EnclosedVolume, is_negative_when_normals_point_inward) {
  SurfaceMesh mesh = shapes::unit_cube();
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  EXPECT_NEAR(volume_of(mesh), -1, 1e-15);
}

TEST(EnclosedVolume, keeps_its_digits_far_from_the_origin) {
  EXPECT_NEAR(volume_of(shapes::box({1e6, 1e6, 1e6}, {1e6 + 1, 1e6 + 1, 1e6 + 1}, 2)), 1, 1e-9);
}

TEST(EnclosedVolume, of_nothing_is_zero) { EXPECT_EQ(enclosed_volume({}, {}), 0); }

TEST(BoundingBox, holds_every_point_and_is_empty_without_any) {
  EXPECT_TRUE(bounding_box({}).empty());
  const Box3 box = bounding_box({{1, 5, -2}, {3, -4, 0}});
  EXPECT_EQ(box.low, (Vec3{1, -4, -2}));
  EXPECT_EQ(box.high, (Vec3{3, 5, 0}));
}

}  // namespace
}  // namespace tetfarm
