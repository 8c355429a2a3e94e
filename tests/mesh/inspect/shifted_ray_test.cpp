#include "mesh/inspect/shifted_ray.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

/// In the plane x = 1, its normal along +x.
const TrianglePoints ahead = {Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{1, 0, 1}};
const TrianglePoints turned = {Vec3{1, 0, 0}, Vec3{1, 0, 1}, Vec3{1, 1, 0}};

TEST(ShiftedRay, passes_a_triangle_ahead_from_behind_or_from_its_front) {
  EXPECT_EQ(ray_passes({0, 0.25, 0.25}, ahead), 1);
  EXPECT_EQ(ray_passes({0, 0.25, 0.25}, turned), -1);
}

TEST(ShiftedRay, passes_no_triangle_behind_it_or_beside_it) {
  EXPECT_EQ(ray_passes({2, 0.25, 0.25}, ahead), 0);
  EXPECT_EQ(ray_passes({2, 0.25, 0.25}, turned), 0);
  EXPECT_EQ(ray_passes({0, 0.75, 0.75}, ahead), 0);
  EXPECT_EQ(ray_passes({0, -0.25, 0.25}, ahead), 0);
  EXPECT_EQ(ray_passes({0, 0.25, -0.25}, ahead), 0);
}

TEST(ShiftedRay, passes_one_of_the_triangles_that_share_an_edge_or_a_corner_on_its_way) {
  // Four triangles of a square round its middle, at each place of which one is passed exactly.
  const std::array<Vec3, 4> corner = {Vec3{1, -1, -1}, Vec3{1, 1, -1}, Vec3{1, 1, 1},
                                      Vec3{1, -1, 1}};
  for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{0, 0.5, 0.5}, Vec3{0, -0.5, 0.5}, Vec3{0, 0.5, -0.5},
                        Vec3{0, -0.5, -0.5}, Vec3{0, 0.2, 0.1}}) {
    int passed = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      passed += ray_passes(p, {Vec3{1, 0, 0}, corner[k], corner[(k + 1) % 4]});
    }
    EXPECT_EQ(passed, 1) << p.y << " " << p.z;
  }
}

TEST(ShiftedRay, never_meets_a_triangle_along_which_it_runs) {
  EXPECT_EQ(ray_passes({0, 0, 0}, {Vec3{1, 0, 0}, Vec3{2, 0, 0}, Vec3{1, 1, 0}}), 0);
  EXPECT_EQ(ray_passes({0, 0, 0}, {Vec3{1, 0, 0}, Vec3{2, 0, 0}, Vec3{1, 0, 1}}), 0);
  EXPECT_EQ(ray_passes({0, 0.5, 0}, {Vec3{1, 0, 0}, Vec3{2, 0.5, 0}, Vec3{1, 1, 0}}), 0);
}

TEST(ShiftedRay, leaves_a_closed_surface_once_more_from_inside_than_from_outside) {
  const SurfaceMesh cube = shapes::box({0, 0, 0}, {1, 1, 1}, 2);
  // On lines through corners, edges and middles of the faces alike.
  for (const double y : {0.5, 0.25, 0.3}) {
    for (const double z : {0.5, 0.75, 0.1}) {
      for (const auto& [x, expected] : {std::pair{-1.0, 0}, {0.5, 1}, {0.25, 1}, {2.0, 0}}) {
        int sum = 0;
        for (const Triangle& t : cube.triangles) {
          sum += ray_passes({x, y, z}, triangle_points(cube.vertices, t));
        }
        EXPECT_EQ(sum, expected) << x << " " << y << " " << z;
      }
    }
  }
}

TEST(ShiftedRay, of_a_point_on_a_triangle_is_told_from_one_beside_it) {
  for (const Vec3& p : {Vec3{1, 0.25, 0.25}, Vec3{1, 0, 0}, Vec3{1, 0.5, 0.5}, Vec3{1, 0, 0.5}}) {
    EXPECT_TRUE(is_on_triangle(p, ahead)) << p.y << " " << p.z;
    EXPECT_TRUE(is_on_triangle(p, turned)) << p.y << " " << p.z;
  }
  for (const Vec3& p : {Vec3{1.0000001, 0.25, 0.25}, Vec3{1, 0.75, 0.75}, Vec3{1, -0.1, 0.5},
                        Vec3{1, 0.5, -0.1}, Vec3{1, 1.5, 0}}) {
    EXPECT_FALSE(is_on_triangle(p, ahead)) << p.x << " " << p.y << " " << p.z;
  }
  // Seen edge on along two of the axes.
  const TrianglePoints level = {Vec3{0, 0, 2}, Vec3{1, 0, 2}, Vec3{0, 1, 2}};
  EXPECT_TRUE(is_on_triangle({0.2, 0.2, 2}, level));
  EXPECT_FALSE(is_on_triangle({0.8, 0.8, 2}, level));
}

}  // namespace
}  // namespace tetfarm
