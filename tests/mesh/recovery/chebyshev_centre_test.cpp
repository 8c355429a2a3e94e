#include "mesh/recovery/chebyshev_centre.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

HalfSpace half_space(const Vec3& normal, double offset) {
  return {fine_vector(normal), {offset, 0}};
}

TEST(DeepestPoint, of_a_box_is_on_its_middle_and_as_deep_as_half_its_thickness) {
  const std::vector<HalfSpace> box = {half_space({1, 0, 0}, 1),    half_space({-1, 0, 0}, 3),
                                      half_space({0, 1, 0}, 2),    half_space({0, -1, 0}, 4),
                                      half_space({0, 0, 1}, 1e-9), half_space({0, 0, -1}, 3e-9)};
  for (const Vec3& x : {chebyshev_centre(box, 10), fine_chebyshev_centre(box, 10).rounded()}) {
    EXPECT_NEAR(x.z, 1e-9, 1e-15);
    EXPECT_GE(x.x, -1);
    EXPECT_LE(x.y, 4);
  }
}

TEST(DeepestPoint, of_a_corner_is_as_far_as_the_reach) {
  const std::vector<HalfSpace> corner = {half_space({1, 0, 0}, 0), half_space({0, 1, 0}, 0),
                                         half_space({0, 0, 1}, 0)};
  for (const Vec3& x : {chebyshev_centre(corner, 2), fine_chebyshev_centre(corner, 2).rounded()}) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(x[axis], 2, 1e-12);
  }
}

TEST(DeepestPoint, behind_planes_that_face_each_other_lies_between_them) {
  const Vec3 x = chebyshev_centre({half_space({1, 0, 0}, -1), half_space({-1, 0, 0}, -1)}, 10);
  EXPECT_NEAR(x.x, 0, 1e-12);
}

TEST(DeepestPoint, in_fine_numbers_is_found_between_planes_that_doubles_take_for_parallel) {
  // A wedge that opens by 1e-20 towards x: its deepest place is at the far end.
  const std::vector<HalfSpace> wedge = {half_space({0, 0, 1}, 1e-25),
                                        half_space({1e-20, 0, -1}, 1e-25)};
  const FineVec3 x = fine_chebyshev_centre(wedge, 1);
  EXPECT_NEAR(x.x.high, 1, 1e-6);
  EXPECT_NEAR(x.z.high, 5e-21, 1e-24);
}

}  // namespace
}  // namespace tetfarm
