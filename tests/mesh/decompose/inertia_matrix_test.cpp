#include "mesh/decompose/inertia_matrix.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

WorkSamples points(const std::vector<Vec3>& at) {
  WorkSamples work;
  for (const Vec3& p : at) work.samples.push_back({p, 1, 1, 1});
  work.total = static_cast<double>(at.size());
  return work;
}

TEST(InertiaMatrix, of_two_points_on_x_resists_turning_about_y_and_z) {
  const InertiaMatrix inertia = inertia_matrix(points({{1, 5, 5}, {3, 5, 5}}));
  EXPECT_EQ(inertia.rows[0], (Vec3{0, 0, 0}));
  EXPECT_EQ(inertia.rows[1].y, 2);
  EXPECT_EQ(inertia.rows[2].z, 2);
}

TEST(InertiaMatrix, longest_direction_comes_first) {
  const auto axes = principal_axes(inertia_matrix(
      points({{0, -3, 0}, {0, 3, 0}, {-2, 0, 0}, {2, 0, 0}, {0, 0, 1}, {0, 0, -1}})));
  EXPECT_NEAR(norm(axes[0] - Vec3{0, 1, 0}), 0, 1e-14);
  EXPECT_NEAR(norm(axes[1] - Vec3{1, 0, 0}), 0, 1e-14);
  EXPECT_NEAR(norm(axes[2] - Vec3{0, 0, 1}), 0, 1e-14);
}

TEST(InertiaMatrix, finds_a_skew_rod) {
  const Vec3 rod = normalized(Vec3{1, -2, 0.5});
  const auto axes = principal_axes(
      inertia_matrix(points({-3 * rod, -1 * rod, rod, 3 * rod, {0.1, 0, 0}, {0, 0, 0.1}})));
  EXPECT_NEAR(std::fabs(dot(axes[0], rod)), 1, 1e-2);
  EXPECT_GT(axes[0].y, 0);  // its largest component
}

TEST(InertiaMatrix, axes_of_anything_are_orthonormal) {
  const auto axes = principal_axes({{Vec3{3, 1, 0.2}, Vec3{1, 2, -0.7}, Vec3{0.2, -0.7, 5}}});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(norm(axes[i]), 1, 1e-14);
    EXPECT_NEAR(dot(axes[i], axes[(i + 1) % 3]), 0, 1e-14);
  }
}

}  // namespace
}  // namespace tetfarm
