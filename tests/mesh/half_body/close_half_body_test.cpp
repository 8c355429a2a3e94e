#include "mesh/half_body/close_half_body.h"

#include <gmock/gmock.h>

#include <numbers>

#include "base/error.h"
#include "mesh/inspect/surface_check.h"
#include "tests/mesh/half_body/half_shapes.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Kind = OuterBoundary::Kind;

const AxisPlane across_y = {1, 0};

HalfBodySpacing even_spacing(const SurfaceMesh&) {
  return [](const Vec3&) { return 0.5; };
}

ClosedHalfBody closed_box(Kind kind, double factor = 3) {
  return close_half_body(open_box({-1, 0, -1}, {1, 1, 1}, 4), across_y, {kind, factor, 0}, 0.3,
                         even_spacing);
}

/// Checked as a job's surface is, and without a defect.
CheckedSurface sound(const SurfaceMesh& surface) {
  CheckedSurface checked = check_surface(surface);
  for (const SurfaceDefect& defect : checked.report.defects) ADD_FAILURE() << defect.message;
  return checked;
}

TEST(HalfBody, gets_half_of_the_box_round_both_halves) {
  const ClosedHalfBody closed = closed_box(Kind::box);
  const CheckedSurface checked = sound(closed.surface);
  const Box3 box = bounding_box(closed.surface.vertices);
  EXPECT_EQ(box.low, (Vec3{-3, 0, -3}));
  EXPECT_EQ(box.high, (Vec3{3, 3, 3}));
  EXPECT_NEAR(domain_volume(checked.surface), 6 * 3 * 6 - 2 * 1 * 2, 1e-9);
  EXPECT_THAT(closed.surface.patch_names, ElementsAre("surface", "outer_box", "symmetry"));
  EXPECT_GT(closed.plane_triangles, 100);
}

TEST(HalfBody, keeps_its_triangles_and_has_those_of_the_plane_exactly_in_it) {
  const SurfaceMesh body = open_box({-1, 0, -1}, {1, 1, 1}, 4);
  const ClosedHalfBody closed = closed_box(Kind::sphere, 4);
  for (std::size_t t = 0; t < body.triangles.size(); ++t) {
    EXPECT_EQ(closed.surface.triangles[t], body.triangles[t]);
    EXPECT_EQ(closed.surface.patch_of_triangle[t], 0);
  }
  std::int64_t within = 0;
  for (std::size_t t = 0; t < closed.surface.triangles.size(); ++t) {
    if (closed.surface.patch_of_triangle[t] != 2) continue;
    ++within;
    for (const std::int32_t v : closed.surface.triangles[t]) {
      EXPECT_EQ(closed.surface.vertices[static_cast<std::size_t>(v)].y, 0);
    }
  }
  EXPECT_EQ(within, closed.plane_triangles);
}

TEST(HalfBody, gets_half_of_the_sphere_on_either_side_of_any_axis) {
  for (const int axis : {0, 1, 2}) {
    for (const double side : {1.0, -1.0}) {
      SurfaceMesh body = open_box({-1, 0, -1}, {1, 1, 1}, 2);
      for (Vec3& v : body.vertices) {
        const Vec3 old = v;
        v[axis] = side * old.y + 0.1;
        v[(axis + 1) % 3] = old.z;
        v[(axis + 2) % 3] = old.x;
      }
      const ClosedHalfBody closed =
          close_half_body(body, {axis, 0.1}, {Kind::sphere, 3, 0.8}, 0.3, even_spacing);
      const double radius = 3 * std::sqrt(3.0);
      const double half = 2.0 / 3 * std::numbers::pi * radius * radius * radius;
      const double volume = domain_volume(sound(closed.surface).surface);
      EXPECT_LT(volume, half - 4);
      EXPECT_GT(volume, 0.97 * half - 4) << axis << " " << side;
    }
  }
}

TEST(HalfBody, without_an_outer_boundary_is_the_wall_of_what_is_in_it) {
  const ClosedHalfBody closed = closed_box(Kind::none);
  EXPECT_NEAR(domain_volume(sound(closed.surface).surface), 4, 1e-12);
  EXPECT_THAT(closed.surface.patch_names, ElementsAre("surface", "symmetry"));
}

TEST(HalfBody, that_is_hollow_has_the_plane_inside_too) {
  SurfaceMesh cup =
      both_of(open_box({-2, 0, -2}, {2, 2, 2}, 4), open_box({-1, 0, -1}, {1, 1, 1}, 4));
  const ClosedHalfBody closed =
      close_half_body(cup, across_y, {Kind::box, 2, 0}, 0.3, even_spacing);
  EXPECT_EQ(closed.ends.loops.size(), 2U);
  EXPECT_NEAR(domain_volume(sound(closed.surface).surface), 8 * 4 * 8 - 4 * 2 * 4 + 2 * 1 * 2,
              1e-9);
}

TEST(HalfBody, may_have_other_bodies_beside_it_and_a_patch_of_the_plane_s_name) {
  SurfaceMesh body =
      both_of(open_box({-1, 0, -1}, {1, 1, 1}, 2), shapes::box({0, 2, 0}, {1, 3, 1}, 1));
  body.patch_names = {"symmetry"};
  body.patch_of_triangle.assign(body.triangles.size(), 0);
  const ClosedHalfBody closed =
      close_half_body(body, across_y, {Kind::box, 2, 0}, 0.3, even_spacing);
  EXPECT_NEAR(domain_volume(sound(closed.surface).surface), 12 * 6 * 12 - 4 - 1, 1e-9);
  EXPECT_THAT(closed.surface.patch_names, ElementsAre("symmetry", "outer_box", "symmetry_2"));
}

TEST(HalfBody, is_refused_where_its_loops_cross) {
  const SurfaceMesh crossing =
      both_of(open_box({0, 0, 0}, {2, 1, 2}, 1), open_box({1, 0, 1}, {3, 1, 3}, 1));
  EXPECT_THAT(
      error_text_of<InvalidInput>([&] {
        close_half_body(crossing, across_y, {Kind::box, 3, 0}, 0.3, even_spacing);
      }),
      HasSubstr("symmetry y=0: the loops in which the surface ends there bound no region: "));
}

}  // namespace
}  // namespace tetfarm
