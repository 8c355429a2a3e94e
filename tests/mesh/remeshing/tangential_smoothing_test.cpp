#include "mesh/remeshing/tangential_smoothing.h"

#include <gmock/gmock.h>

#include "tests/mesh/remeshing/remeshing_fixture.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;

/// A box with n x n squares on each side, of which all vertices inside faces are pushed along x.
SurfaceMesh pushed_box(double push) {
  SurfaceMesh box = shapes::box({0, 0, 0}, {1, 1, 1}, 4);
  for (Vec3& v : box.vertices) {
    const bool is_top = v.z == 1;
    const bool is_inside = v.x > 0 && v.x < 1 && v.y > 0 && v.y < 1;
    if (is_top && is_inside) v.x += push;
  }
  return box;
}

TEST(TangentialSmoothing, evens_a_plane_out_and_stays_in_it) {
  SurfaceToChange box(pushed_box(0.15), 0.25, 0.01);
  const auto worst = [&] {
    double least = 1;
    for (std::int32_t t = 0; t < box.surface.triangle_end(); ++t) {
      least = std::min(least, triangle_shape(box.surface.points(box.surface.triangle(t).nodes)));
    }
    return least;
  };
  const double before = worst();
  for (int i = 0; i < 10; ++i) smooth_vertices(box.work, 0.9);
  EXPECT_GT(worst(), before);
  EXPECT_NEAR(volume_of(box.surface), 1, 1e-14);
  EXPECT_THAT(complaints_of(box.surface), IsEmpty());
}

TEST(TangentialSmoothing, leaves_corners_and_keeps_curves_on_their_lines) {
  SurfaceMesh box = shapes::box({0, 0, 0}, {1, 1, 1}, 4);
  for (Vec3& v : box.vertices) {
    if (v.y == 0 && v.z == 0 && v.x > 0 && v.x < 1) v.x = v.x * v.x;
  }
  SurfaceToChange uneven(box, 0.25, 0.01);
  for (int i = 0; i < 20; ++i) smooth_vertices(uneven.work, 0.9);
  for (std::int32_t v = 0; v < uneven.surface.vertex_end(); ++v) {
    const auto number = static_cast<std::size_t>(v);
    const Vec3& at = uneven.surface.at(v);
    if (uneven.surface.vertex(v).kind == VertexKind::corner) {
      EXPECT_EQ(at, box.vertices[number]);
    }
    if (box.vertices[number].y == 0 && box.vertices[number].z == 0) {
      EXPECT_EQ(at.y, 0);
      EXPECT_EQ(at.z, 0);
      const double shares = at.x / 0.25;
      EXPECT_NEAR(shares, std::round(shares), 0.05);
    }
  }
}

TEST(TangentialSmoothing, keeps_a_sphere_s_vertices_on_the_input) {
  SurfaceToChange sphere(shapes::sphere({0, 0, 0}, 1, 2), 0.3, 0.02);
  smooth_vertices(sphere.work, 0.9);
  for (std::int32_t v = 0; v < sphere.surface.vertex_end(); ++v) {
    const Vec3& at = sphere.surface.at(v);
    EXPECT_TRUE(sphere.shape.on_face(0, at, at, 1e-12, -1)) << v;
  }
}

}  // namespace
}  // namespace tetfarm
