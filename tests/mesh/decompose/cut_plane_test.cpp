#include "mesh/decompose/cut_plane.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(CutPlane, has_a_right_handed_orthonormal_frame) {
  for (const Vec3& direction : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, 2, 3},
                                Vec3{-3, 1, 0.5}, Vec3{0, -1, 1}}) {
    const CutPlane plane = make_cut_plane(normalized(direction), 0.5);
    EXPECT_NEAR(norm(plane.u), 1, 1e-15);
    EXPECT_NEAR(norm(plane.v), 1, 1e-15);
    EXPECT_NEAR(dot(plane.u, plane.normal), 0, 1e-15);
    EXPECT_NEAR(norm(cross(plane.u, plane.v) - plane.normal), 0, 1e-15);
  }
}

TEST(CutPlane, of_an_axis_projects_without_rounding) {
  const Vec3 p{0.1, 0.2, 0.3};
  EXPECT_EQ(make_cut_plane({1, 0, 0}, 0).project(p), (Vec2{0.2, 0.3}));
  EXPECT_EQ(make_cut_plane({0, 1, 0}, 0).project(p), (Vec2{0.3, 0.1}));
  EXPECT_EQ(make_cut_plane({0, 0, 1}, 0).project(p), (Vec2{0.1, 0.2}));
}

TEST(CutPlane, lift_undoes_project) {
  const CutPlane plane = make_cut_plane(normalized(Vec3{1, -2, 0.7}), 0.4);
  const Vec3 p{3, 4, -5};
  EXPECT_NEAR(distance(plane.lift(plane.project(p), plane.height(p)), p), 0, 1e-14);
}

}  // namespace
}  // namespace tetfarm
