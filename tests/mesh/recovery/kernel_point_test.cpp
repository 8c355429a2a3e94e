#include "mesh/recovery/kernel_point.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

TEST(KernelPoint, of_a_cube_is_well_inside_and_of_facing_away_planes_there_is_none) {
  const SurfaceMesh cube = shapes::unit_cube();
  std::vector<VisibleFace> faces;
  for (const auto& [a, b, c] : cube.triangles) {
    const auto p = [&cube](std::int32_t v) {
      return fine(cube.vertices[static_cast<std::size_t>(v)]);
    };
    faces.push_back({p(a), p(c), p(b)});
  }
  const auto point = kernel_point(faces, fine({0, 0, 0}));
  ASSERT_TRUE(point.has_value());
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(point->high[axis], 0.5, 0.2);
  const std::vector<VisibleFace> opposed = {{fine({0, 0, 1}), fine({1, 0, 1}), fine({0, 1, 1})},
                                            {fine({0, 0, 0}), fine({0, 1, 0}), fine({1, 0, 0})}};
  EXPECT_FALSE(kernel_point(opposed, fine({0, 0, 0})).has_value());
}

TEST(KernelPoint, is_found_in_a_wedge_far_thinner_than_the_last_digit_of_doubles) {
  const double height = std::ldexp(1.0, -80);
  const auto lifted = [height](double x, double y) { return FinePoint{{x, y, 1}, {0, 0, height}}; };
  const std::vector<VisibleFace> faces = {{fine({0, 0, 1}), fine({1, 0, 1}), fine({0, 1, 1})},
                                          {lifted(0, 0), lifted(0, 1), lifted(1, 0)}};
  const auto point = kernel_point(faces, fine({0.3, 0.3, 1}));
  ASSERT_TRUE(point.has_value());
  EXPECT_TRUE(sees_all(faces, *point));
  EXPECT_FALSE(sees_all(faces, fine({0.3, 0.3, 1})));
}

}  // namespace
}  // namespace tetfarm
