#include "mesh/inspect/self_intersection.h"

#include <gmock/gmock.h>

#include "tests/mesh/inspect/check_support.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

std::optional<SurfaceDefect> check(const SurfaceMesh& mesh) {
  return check_self_intersection(mesh, std::vector<char>(mesh.triangles.size(), 1));
}

TEST(SelfIntersection, is_none_in_good_shapes) {
  EXPECT_FALSE(check(shapes::box({0, 0, 0}, {1, 2, 3}, 5)));
  EXPECT_FALSE(check(shapes::nested_spheres(2)));
  EXPECT_FALSE(check(shapes::torus(0.4, 12, 9)));
}

TEST(SelfIntersection, finds_cubes_that_pierce_each_other) {
  const auto defect =
      check(joined(shapes::unit_cube(), shapes::box({0.5, 0.25, 0.3}, {2, 2, 2}, 1)));
  ASSERT_TRUE(defect);
  EXPECT_EQ(defect->kind, "self-intersection");
  EXPECT_THAT(defect->message, HasSubstr("triangle 2 (1, "));
  EXPECT_TRUE(std::ranges::is_sorted(defect->triangles));
  EXPECT_LT(defect->triangles.front(), 12);
  EXPECT_GE(defect->triangles.back(), 12);
}

TEST(SelfIntersection, includes_shells_that_only_touch) {
  EXPECT_TRUE(check(joined(shapes::unit_cube(), shapes::box({1, 0.25, 0.25}, {2, 0.5, 0.5}, 1))));
  EXPECT_TRUE(check(joined(shapes::unit_cube(), shapes::box({1, 1, 1}, {2, 2, 2}, 1))))
      << "corners at one place under two numbers";
  const double beyond = std::nextafter(1.0, 2.0);
  EXPECT_FALSE(check(joined(shapes::unit_cube(), shapes::box({beyond, 0, 0}, {2, 1, 1}, 1))));
}

TEST(SelfIntersection, allows_shells_that_share_a_vertex) {
  EXPECT_FALSE(check(welded(joined(shapes::unit_cube(), shapes::box({1, 1, 1}, {2, 2, 2}, 1)))));
}

TEST(SelfIntersection, finds_a_vertex_pushed_through_the_other_side) {
  SurfaceMesh mesh = shapes::sphere({0, 0, 0}, 1, 2);
  mesh.vertices[0] = -1.5 * mesh.vertices[0];
  const auto defect = check(mesh);
  ASSERT_TRUE(defect);
  EXPECT_THAT(defect->message, HasSubstr("pairs of triangles"));
}

TEST(SelfIntersection, skips_what_the_sieve_holds_back) {
  const SurfaceMesh mesh = joined(shapes::unit_cube(), shapes::box({0.5, 0.5, 0.5}, {2, 2, 2}, 1));
  std::vector<char> first(24, 0);
  std::fill_n(first.begin(), 12, 1);
  EXPECT_FALSE(check_self_intersection(mesh, first));
}

}  // namespace
}  // namespace tetfarm
