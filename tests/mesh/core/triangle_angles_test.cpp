#include "mesh/core/triangle_angles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

TEST(TriangleAngles, of_a_known_triangle_are_known_wherever_it_begins) {
  const Vec3 a{0, 0, 0};
  const Vec3 b{1, 0, 0};
  const Vec3 c{0, std::tan(20 * std::numbers::pi / 180), 0};
  EXPECT_NEAR(smallest_angle_deg(a, b, c), 20, 1e-12);
  EXPECT_NEAR(smallest_angle_deg(b, c, a), 20, 1e-12);
  EXPECT_NEAR(smallest_angle_deg(c, b, a), 20, 1e-12);
}

TEST(TriangleAngles, are_right_where_their_cosine_rounds_to_1) {
  EXPECT_NEAR(smallest_angle_deg({0, 0, 0}, {1, 0, 0}, {1, 1e-10, 0}),
              1e-10 * 180 / std::numbers::pi, 1e-15);
  EXPECT_EQ(smallest_angle_deg({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), 0);
}

TEST(TriangleAngles, needles_are_counted) {
  SurfaceMesh mesh = shapes::unit_cube();
  EXPECT_EQ(needle_count(mesh.vertices, mesh.triangles), 0);
  for (Vec3& v : mesh.vertices) v.z *= 0.2;  // 8 triangles on the sides
  EXPECT_EQ(needle_count(mesh.vertices, mesh.triangles), 8);
}

TEST(TriangleAngles, needles_are_those_below_their_angle_whatever_the_triangle) {
  std::uint64_t state = 1;
  const auto by_chance = [&state] {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state >> 11U) / 9007199254740992.0 - 0.5;
  };
  int needles = 0;
  for (int i = 0; i < 2000; ++i) {
    // One triangle in two has an angle within a hundredth of a degree of the limit.
    const double angle = (needle_deg + 0.02 * by_chance()) * std::numbers::pi / 180;
    const double side = 2 + by_chance();
    const Vec3 c = i % 2 == 0 ? Vec3{by_chance(), by_chance(), by_chance()}
                              : Vec3{side * std::cos(angle), side * std::sin(angle), 0};
    const std::vector<Vec3> corners = {{0, 0, 0}, {1, 0, 0}, c};
    const bool is_needle = smallest_angle_deg(corners[0], corners[1], corners[2]) < needle_deg;
    EXPECT_EQ(needle_count(corners, {{i % 3, (i + 1) % 3, (i + 2) % 3}}), is_needle ? 1 : 0);
    if (is_needle) ++needles;
  }
  EXPECT_GT(needles, 400);
  EXPECT_LT(needles, 1800);
}

}  // namespace
}  // namespace tetfarm
