#include "mesh/volume/deepest_point.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(DeepestPoint, of_a_box_is_on_its_middle_and_as_deep_as_half_its_thickness) {
  const std::vector<HalfSpace> box = {{{1, 0, 0}, 1},  {{-1, 0, 0}, 3},   {{0, 1, 0}, 2},
                                      {{0, -1, 0}, 4}, {{0, 0, 1}, 1e-9}, {{0, 0, -1}, 3e-9}};
  const Vec3 x = deepest_point(box, 10);
  EXPECT_NEAR(x.z, 1e-9, 1e-15);
  EXPECT_GE(x.x, -1);
  EXPECT_LE(x.y, 4);
}

TEST(DeepestPoint, of_a_corner_is_as_far_as_the_reach) {
  const Vec3 x = deepest_point({{{1, 0, 0}, 0}, {{0, 1, 0}, 0}, {{0, 0, 1}, 0}}, 2);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(x[axis], 2, 1e-12);
}

TEST(DeepestPoint, behind_planes_that_face_each_other_lies_between_them) {
  const Vec3 x = deepest_point({{{1, 0, 0}, -1}, {{-1, 0, 0}, -1}}, 10);
  EXPECT_NEAR(x.x, 0, 1e-12);
}

}  // namespace
}  // namespace tetfarm
