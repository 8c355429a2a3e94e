#include "mesh/shapes/box_and_sphere.h"

#include <gmock/gmock.h>

#include <set>

#include "mesh/inspect/surface_check.h"
#include "tests/mesh/inspect/check_support.h"

namespace tetfarm {
namespace {

TEST(BoxAndSphere, are_closed_and_face_outward) {
  for (const int n : {1, 2, 3, 6}) {
    const Box3 box{{-1, -2, -3}, {0.1, 0.2, 0.3}};
    const SurfaceMesh brick = box_surface(box, n);
    const SurfaceMesh sphere = sphere_surface({1, 2, 3}, 2, n);
    EXPECT_EQ(brick.triangles.size(), static_cast<std::size_t>(12 * n * n));
    EXPECT_EQ(sphere.triangles.size(), static_cast<std::size_t>(20 * n * n));
    EXPECT_EQ(brick.vertices.size(), brick.triangles.size() / 2 + 2);
    EXPECT_EQ(sphere.vertices.size(), sphere.triangles.size() / 2 + 2);
    for (const SurfaceMesh& mesh : {brick, sphere}) {
      const CheckedSurface checked = check_surface(mesh);
      EXPECT_THAT(kinds(checked.report), testing::IsEmpty());
      EXPECT_THAT(checked.report.remarks, testing::IsEmpty());
    }
    EXPECT_NEAR(check_surface(brick).report.volume, 1.1 * 2.2 * 3.3, 1e-12);
    EXPECT_EQ(bounding_box(brick.vertices).high, box.high);
    EXPECT_EQ(bounding_box(brick.vertices).low, box.low);
  }
}

TEST(BoxAndSphere, force_no_tetrahedron_into_a_corner_of_the_box) {
  const SurfaceMesh brick = box_surface({{0, 0, 0}, {1, 1, 1}}, 3);
  for (std::size_t v = 0; v < brick.vertices.size(); ++v) {
    const Vec3 p = brick.vertices[v];
    const bool is_corner =
        (p.x == 0 || p.x == 1) && (p.y == 0 || p.y == 1) && (p.z == 0 || p.z == 1);
    if (!is_corner) continue;
    const auto around = std::ranges::count_if(brick.triangles, [v](const Triangle& t) {
      return std::ranges::count(t, static_cast<std::int32_t>(v)) > 0;
    });
    EXPECT_EQ(around, 6);
  }
}

TEST(BoxAndSphere, of_a_sphere_are_even) {
  const SurfaceMesh sphere = sphere_surface({0, 0, 0}, 10, 12);
  for (const Vec3& p : sphere.vertices) EXPECT_NEAR(norm(p), 10, 1e-12);
  const SurfaceReport report = check_surface(sphere).report;
  EXPECT_LT(report.longest_edge, 1.5 * report.shortest_edge);
  EXPECT_GT(report.smallest_angle_deg, 45);
  EXPECT_LT(nearest_plane(sphere, {0, 0, 0}), 10);
  EXPECT_GT(nearest_plane(sphere, {0, 0, 0}), 9.9);
  const SurfaceMesh coarse = sphere_surface({0, 0, 0}, 1, 1);
  // The insphere of an icosahedron.
  EXPECT_NEAR(nearest_plane(coarse, {0, 0, 0}), 0.79465447229176612, 1e-12);
}

}  // namespace
}  // namespace tetfarm
