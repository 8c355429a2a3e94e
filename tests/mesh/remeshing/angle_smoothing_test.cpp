#include "mesh/remeshing/angle_smoothing.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "tests/mesh/remeshing/remeshing_fixture.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;

constexpr double cosine_of_35 = 0.8192;

/// The largest cosine of an angle of the triangles there.
double sharpest_of(const ChangingSurface& surface) {
  double sharpest = -1;
  for (std::int32_t t = 0; t < surface.triangle_end(); ++t) {
    if (!surface.is_there(t)) continue;
    const TrianglePoints c = surface.points(surface.triangle(t).nodes);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 u = c[(k + 1) % 3] - c[k];
      const Vec3 v = c[(k + 2) % 3] - c[k];
      sharpest = std::max(sharpest, dot(u, v) / std::sqrt(norm2(u) * norm2(v)));
    }
  }
  return sharpest;
}

/// A box of 4 x 4 squares on each side, one vertex of whose top is pushed towards another.
SurfaceMesh dented_box(double push) {
  SurfaceMesh box = shapes::box({0, 0, 0}, {1, 1, 1}, 4);
  for (Vec3& v : box.vertices) {
    if (v == Vec3{0.5, 0.5, 1}) v.x += push;
  }
  return box;
}

TEST(AngleSmoothing, raises_the_smallest_angle_and_stays_in_the_plane) {
  SurfaceToChange box(dented_box(0.22), 0.25, 0.01);
  EXPECT_GT(sharpest_of(box.surface), std::cos(0.12)) << "7 degrees";
  EXPECT_GT(raise_angles(box.work, cosine_of_35), 0);
  EXPECT_LT(sharpest_of(box.surface), std::cos(0.36)) << "20 degrees";
  EXPECT_NEAR(volume_of(box.surface), 1, 1e-14);
  EXPECT_THAT(complaints_of(box.surface), IsEmpty());
}

TEST(AngleSmoothing, moves_nothing_where_all_angles_are_large_enough) {
  SurfaceToChange box(dented_box(0.01), 0.25, 0.01);
  EXPECT_EQ(raise_angles(box.work, cosine_of_35), 0);
}

TEST(AngleSmoothing, leaves_what_is_on_curves_and_in_corners) {
  SurfaceMesh box = shapes::box({0, 0, 0}, {1, 1, 1}, 4);
  for (Vec3& v : box.vertices) {
    if (v.y == 0 && v.z == 0 && v.x > 0 && v.x < 1) v.x = v.x * v.x;
  }
  SurfaceToChange uneven(box, 0.25, 0.01);
  raise_angles(uneven.work, cosine_of_35);
  for (std::int32_t v = 0; v < uneven.surface.vertex_end(); ++v) {
    if (uneven.surface.vertex(v).kind == VertexKind::smooth) continue;
    EXPECT_EQ(uneven.surface.at(v), box.vertices[static_cast<std::size_t>(v)]);
  }
}

TEST(AngleSmoothing, keeps_a_sphere_s_vertices_on_the_input_and_its_triangles_apart) {
  SurfaceMesh ball = shapes::sphere({0, 0, 0}, 1, 3);
  ball.vertices[40] = normalized(ball.vertices[40] + Vec3{0.06, 0.05, -0.04});
  SurfaceToChange sphere(ball, 0.15, 0.02);
  const double before = sharpest_of(sphere.surface);
  EXPECT_GT(raise_angles(sphere.work, cosine_of_35), 0);
  EXPECT_LT(sharpest_of(sphere.surface), before);
  for (std::int32_t v = 0; v < sphere.surface.vertex_end(); ++v) {
    const Vec3& at = sphere.surface.at(v);
    EXPECT_TRUE(sphere.shape.on_face(0, at, at, 1e-12, -1)) << v;
  }
}

}  // namespace
}  // namespace tetfarm
