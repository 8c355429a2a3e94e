#include "mesh/render/camera.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace tetfarm {
namespace {

Vec3 corner(const Box3& box, int i) {
  return {(i & 1) != 0 ? box.high.x : box.low.x, (i & 2) != 0 ? box.high.y : box.low.y,
          (i & 4) != 0 ? box.high.z : box.low.z};
}

std::array<Vec3, 8> corners(const Box3& box) {
  std::array<Vec3, 8> all;
  for (int i = 0; i < 8; ++i) all[static_cast<std::size_t>(i)] = corner(box, i);
  return all;
}

TEST(Camera, fits_what_it_looks_at_into_the_picture_from_every_side) {
  const Box3 focus{{3, -2, 5}, {4, 6, 5.5}};
  const Box3 all{{-40, -30, -20}, {30, 40, 20}};
  for (const Vec3& from : {Vec3{-1, -2, 1}, Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0.3, 5, -4}}) {
    const Camera camera(all, corners(focus), {from, {0, 0, 1}, 1, {}, {}}, 800, 500);
    double farthest = 0;
    for (int i = 0; i < 8; ++i) {
      const Seen seen = camera.project(corner(focus, i));
      EXPECT_GT(seen.depth, 0);
      EXPECT_GE(seen.x, 0);
      EXPECT_LE(seen.x, 800);
      EXPECT_GE(seen.y, 0);
      EXPECT_LE(seen.y, 500);
      farthest = std::max({farthest, std::fabs(seen.x - 400) / 400, std::fabs(seen.y - 250) / 250});
      EXPECT_GT(camera.project(corner(all, i)).depth, 0) << "behind the eye";
    }
    EXPECT_GT(farthest, 0.9) << "the picture is not filled";
  }
}

TEST(Camera, shows_up_above_and_right_on_the_right) {
  const Box3 box{{-1, -1, -1}, {1, 1, 1}};
  const Camera camera(box, corners(box), {{0, -1, 0}, {0, 0, 1}, 1, {}, {}}, 100, 100);
  EXPECT_LT(camera.project({0, 0, 1}).y, camera.project({0, 0, -1}).y);
  EXPECT_GT(camera.project({1, 0, 0}).x, camera.project({-1, 0, 0}).x);
  EXPECT_LT(camera.project({0, -1, 0}).depth, camera.project({0, 1, 0}).depth);
  const Camera nearer(box, corners(box), {{0, -1, 0}, {0, 0, 1}, 2, {}, {}}, 100, 100);
  EXPECT_NEAR(nearer.project({0.5, 0, 0}).x - 50, 2 * (camera.project({0.5, 0, 0}).x - 50), 1e-9);
}

TEST(Camera, has_what_it_is_told_to_in_the_middle_of_the_picture_at_any_zoom) {
  const Box3 box{{-1, -1, -1}, {1, 1, 1}};
  const Vec3 centre{0.3, -0.2, 0.9};
  const double far =
      Camera(box, corners(box), {{1, -2, 1}, {0, 0, 1}, 1, {}, {}}, 100, 60).project(centre).x;
  for (const double zoom : {1.0, 1000.0}) {
    const Camera camera(box, corners(box), {{1, -2, 1}, {0, 0, 1}, zoom, {}, centre}, 100, 60);
    EXPECT_NEAR(camera.project(centre).x, 50, 1e-9);
    EXPECT_NEAR(camera.project(centre).y, 30, 1e-9);
  }
  EXPECT_GT(std::abs(far - 50), 1) << "where it would be";
}

TEST(Camera, is_as_wide_at_the_centre_as_it_is_told_to) {
  const Box3 box{{-1, -1, -1}, {1, 1, 1}};
  CameraOptions options{{0, -1, 0}, {0, 0, 1}, 1, {}, {}};
  options.centre = Vec3{0.5, 0.25, 0.5};
  options.across = 0.002;
  const Camera camera(box, corners(box), options, 100, 60);
  EXPECT_NEAR(camera.project({0.499, 0.25, 0.5}).x, 0, 1e-6);
  EXPECT_NEAR(camera.project({0.501, 0.25, 0.5}).x, 100, 1e-6);
}

TEST(Camera, has_a_right_side_also_where_up_is_ahead) {
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    for (const Vec3& from : {axis, -axis}) {
      const ViewAxes axes = view_axes({from, axis, 1, {}, {}});
      EXPECT_DOUBLE_EQ(norm(axes.right), 1);
      EXPECT_DOUBLE_EQ(norm(axes.up), 1);
      EXPECT_DOUBLE_EQ(dot(axes.right, axes.up), 0);
      EXPECT_DOUBLE_EQ(dot(axes.right, axis), 0);
    }
  }
}

}  // namespace
}  // namespace tetfarm
