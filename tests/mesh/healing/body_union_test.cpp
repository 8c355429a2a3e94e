#include "mesh/healing/body_union.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/mesh/healing/damaged_surface.h"
#include "tests/mesh/healing/random_bodies.h"

namespace tetfarm {
namespace {

using ::testing::Each;
using ::testing::Field;
using ::testing::IsEmpty;
using ::testing::SizeIs;

SurfaceMesh box_of(const Vec3& low, const Vec3& high, int n = 1) {
  return shapes::box(low, high, n);
}

SurfaceMesh turned(SurfaceMesh surface) {
  for (Triangle& t : surface.triangles) std::swap(t[1], t[2]);
  return surface;
}

double united_volume(test::Damaged& bodies) {
  const CheckedSurface checked = check_surface(bodies.surface);
  EXPECT_THAT(checked.report.defects, IsEmpty());
  return checked.report.volume;
}

TEST(BodyUnion, of_two_boxes_that_go_through_each_other) {
  test::Damaged two(
      test::with_body(box_of({0, 0, 0}, {1, 1, 1}, 3), box_of({0.5, 0.4, 0.3}, {2, 0.9, 0.8}, 2)));
  EXPECT_EQ(unite_bodies(two.work), 2);
  EXPECT_NEAR(united_volume(two), 1 + 0.25, 1e-12);
  EXPECT_THAT(two.acts, SizeIs(2));
  EXPECT_THAT(two.acts, Each(Field(&HealAct::kind, HealKind::united)));
  EXPECT_FALSE(two.acts[0].triangles.empty()) << "what it made, to look at";
}

TEST(BodyUnion, of_bodies_that_stand_on_each_other) {
  test::Damaged stack(
      test::with_body(box_of({0, 0, 0}, {1, 1, 1}), box_of({0.25, 0.25, 1}, {0.75, 0.75, 2}, 2)));
  EXPECT_EQ(unite_bodies(stack.work), 2);
  EXPECT_NEAR(united_volume(stack), 1.25, 1e-12);
}

TEST(BodyUnion, turns_what_faces_inward) {
  test::Damaged two(test::with_body(turned(box_of({0, 0, 0}, {1, 1, 1})),
                                    box_of({0.5, 0.4, 0.3}, {2, 0.9, 0.8})));
  EXPECT_EQ(unite_bodies(two.work), 2);
  EXPECT_NEAR(united_volume(two), 1.25, 1e-12);
}

TEST(BodyUnion, a_body_inside_goes_and_a_cavity_stays) {
  SurfaceMesh all =
      test::with_body(box_of({0, 0, 0}, {1, 1, 1}), box_of({0.5, 0.4, 0.3}, {2, 0.9, 0.8}));
  all = test::with_body(all, box_of({0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}));
  all = test::with_body(all, turned(box_of({1.5, 0.5, 0.4}, {1.6, 0.6, 0.5})));
  for (const bool is_inside_out : {false, true}) {
    test::Damaged bodies(is_inside_out ? turned(all) : all);
    EXPECT_EQ(unite_bodies(bodies.work), 3);
    EXPECT_NEAR(united_volume(bodies), 1.25 - 0.001, 1e-12);
    EXPECT_EQ(std::ranges::count(bodies.acts, HealKind::inside, &HealAct::kind), 1);
  }
}

TEST(BodyUnion, a_tube_through_itself_is_filled_where_it_is_twice) {
  // A box whose right half was pushed through its left one.
  SurfaceMesh bar = box_of({0, 0, 0}, {4, 1, 1}, 8);
  for (Vec3& p : bar.vertices) {
    const double turn = 1.75 * std::numbers::pi * p.x / 4;
    const double radius = 1 + p.y - 0.3 * p.x / 4;
    p = {radius * std::cos(turn), radius * std::sin(turn), p.z};
  }
  for (Vec3& p : bar.vertices) {
    if (p.y < -0.2 && p.x > 0) p.y += 1.5;
  }
  test::Damaged bent(bar);
  if (test::defects_of(bar).empty()) GTEST_FAIL() << "does not go through itself";
  EXPECT_EQ(unite_bodies(bent.work), 1);
  EXPECT_GT(united_volume(bent), 0);
}

TEST(BodyUnion, keeps_patches) {
  SurfaceMesh two = box_of({0, 0, 0}, {1, 1, 1});
  two.patch_names = {"block", "pin"};
  two.patch_of_triangle.assign(two.triangles.size(), 0);
  const std::size_t of_block = two.triangles.size();
  two = test::with_body(two, box_of({0.5, 0.4, 0.3}, {2, 0.9, 0.8}));
  for (std::size_t t = of_block; t < two.triangles.size(); ++t) two.patch_of_triangle[t] = 1;
  test::Damaged bodies(two);
  ASSERT_EQ(unite_bodies(bodies.work), 2);
  EXPECT_THAT(bodies.surface.patch_of_triangle, SizeIs(bodies.surface.triangles.size()));
  for (std::size_t t = 0; t < bodies.surface.triangles.size(); ++t) {
    const TrianglePoints c = points_of(bodies.surface, t);
    const double x = (c[0].x + c[1].x + c[2].x) / 3;
    if (std::abs(x - 1) < 1e-3) continue;
    EXPECT_EQ(bodies.surface.patch_of_triangle[t], x > 1 ? 1 : 0);
  }
}

TEST(BodyUnion, leaves_an_open_surface_and_one_that_meets_nothing) {
  SurfaceMesh open =
      test::with_body(box_of({0, 0, 0}, {1, 1, 1}), box_of({0.5, 0.4, 0.3}, {2, 0.9, 0.8}));
  test::remove_triangle(open, 3);
  test::Damaged torn(open);
  EXPECT_EQ(unite_bodies(torn.work), 0);
  EXPECT_EQ(torn.surface.triangles, open.triangles);
  const SurfaceMesh ball = shapes::sphere({0, 0, 0}, 1, 1);
  test::Damaged sound(ball);
  EXPECT_EQ(unite_bodies(sound.work), 0);
  EXPECT_EQ(sound.surface.triangles, ball.triangles);
}

TEST(BodyUnion, encloses_just_what_one_of_the_bodies_does) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const test::RandomBodies bodies(seed);
    test::Damaged work(bodies.all());
    ASSERT_GT(unite_bodies(work.work), 1);
    ASSERT_THAT(test::defects_of(work.surface), IsEmpty());
    EXPECT_THAT(bodies.points_told_wrongly_by(work.surface, 200), IsEmpty());
  }
}

}  // namespace
}  // namespace tetfarm
