#include "mesh/inspect/region_map.h"

#include <gmock/gmock.h>

#include <random>

#include "tests/mesh/inspect/check_support.h"
#include "tests/support/shapes.h"
#include "tests/support/voxel_surface.h"

namespace tetfarm {
namespace {

RegionMap map_of(const SurfaceMesh& surface) {
  const std::vector<EdgeUse> uses =
      edge_uses(surface.triangles, std::vector<char>(surface.triangles.size(), 1));
  return RegionMap(surface, join_sides(surface, uses));
}

/// Cubes round the origin, of sides 4, 6, 2: one in the other.
SurfaceMesh nested_cubes() {
  SurfaceMesh mesh = shapes::box({-2, -2, -2}, {2, 2, 2}, 2);
  for (const double half : {3.0, 1.0}) {
    mesh = joined(mesh, shapes::box({-half, -half, -half}, {half, half, half}, 2));
  }
  return mesh;
}

TEST(RegionMap, of_nested_shells_has_one_region_between_each_and_the_next) {
  const SurfaceMesh surface = nested_cubes();
  const RegionMap map = map_of(surface);
  ASSERT_EQ(map.regions(), 3);
  EXPECT_EQ(map.parts().size(), 3U);
  EXPECT_FALSE(map.unclear_part());
  const auto region_at_x = [&](double x) { return map.region_at({x, 0.1, 0.2}).value(); };
  EXPECT_EQ(region_at_x(9), 0);
  EXPECT_NEAR(map.volume(region_at_x(2.5)), 216 - 64, 1e-9);
  EXPECT_NEAR(map.volume(region_at_x(1.5)), 64 - 8, 1e-9);
  EXPECT_NEAR(map.volume(region_at_x(0.5)), 8, 1e-9);
  EXPECT_NEAR(map.volume(0), -216, 1e-9) << "minus that of all else";
  EXPECT_EQ(map.depth(region_at_x(2.5)), 1);
  EXPECT_EQ(map.depth(region_at_x(1.5)), 2);
  EXPECT_EQ(map.depth(region_at_x(0.5)), 3);
}

TEST(RegionMap, tells_parts_by_what_is_round_them) {
  const SurfaceMesh surface = nested_cubes();
  const std::vector<RegionMap::Part> parts = map_of(surface).parts();
  // In the order of their triangles: the one between, the largest, the smallest.
  EXPECT_EQ(parts[0].parent, 1);
  EXPECT_EQ(parts[1].parent, -1);
  EXPECT_EQ(parts[2].parent, 0);
  EXPECT_EQ(parts[2].depth, 2);
  EXPECT_NEAR(parts[2].volume, 8, 1e-9);
}

TEST(RegionMap, knows_of_every_point_the_region_and_of_points_on_the_surface_that_they_are) {
  const SurfaceMesh surface = nested_cubes();
  const RegionMap map = map_of(surface);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(-4, 4);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p{place(random), place(random), place(random)};
    const double away = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    const int depth = away > 3 ? 0 : away > 2 ? 1 : away > 1 ? 2 : 3;
    EXPECT_EQ(map.depth(map.region_at(p).value()), depth);
  }
  for (const Vec3& p : {Vec3{3, 0.5, 0.1}, Vec3{-1, -1, 0.3}, Vec3{2, 2, 2}}) {
    EXPECT_EQ(map.region_at(p), std::nullopt);
  }
}

TEST(RegionMap, has_the_regions_on_both_sides_of_each_triangle_of_an_interface) {
  const SurfaceMesh surface =
      shapes::voxel_surface({{2, 1, 1}, [](int x, int, int) { return x + 1; }}).surface;
  const RegionMap map = map_of(surface);
  ASSERT_EQ(map.regions(), 2);
  int between = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Sides sides = map.sides_of(t);
    EXPECT_NE(sides[0], sides[1]);
    between += sides[0] > 0 && sides[1] > 0 ? 1 : 0;
  }
  EXPECT_EQ(between, 2);
  EXPECT_NEAR(map.volume(1), 1, 1e-12);
  EXPECT_NEAR(map.volume(2), 1, 1e-12);
  EXPECT_EQ(map.parts().size(), 1U);
}

}  // namespace
}  // namespace tetfarm
