#include "dashboard/fewer_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

FewerTriangles fewer(const SurfaceMesh& surface, std::size_t most) {
  return fewer_triangles(surface.vertices, surface.triangles, most);
}

TEST(FewerTriangles, are_all_of_a_surface_that_has_no_more) {
  const SurfaceMesh cube = shapes::unit_cube();
  const FewerTriangles left = fewer(cube, cube.triangles.size());
  EXPECT_EQ(left.vertices, cube.vertices);
  EXPECT_EQ(left.triangles, cube.triangles);
  ASSERT_EQ(left.was.size(), cube.triangles.size());
  for (std::size_t i = 0; i < left.was.size(); ++i) EXPECT_EQ(left.was[i], i);
}

TEST(FewerTriangles, are_at_most_as_many_as_asked_for_and_of_a_thousand_more_than_a_third) {
  for (const SurfaceMesh& surface :
       {shapes::sphere({1e6, 0, 0}, 3, 5), shapes::box({0, 0, 0}, {10, 1, 0.1}, 40),
        shapes::torus(0.3, 90, 60)}) {
    for (const std::size_t most : {64U, 1000U, 4000U}) {
      const FewerTriangles left = fewer(surface, most);
      EXPECT_LE(left.triangles.size(), most);
      EXPECT_TRUE(most < 1000U || 3 * left.triangles.size() > most);
    }
  }
}

TEST(FewerTriangles, are_triangles_between_three_vertices_each_once_and_near_where_they_were) {
  const SurfaceMesh sphere = shapes::sphere({0, 0, 0}, 1, 5);
  const FewerTriangles left = fewer(sphere, 2000);
  ASSERT_EQ(left.was.size(), left.triangles.size());
  std::set<Triangle> seen;
  std::set<std::int32_t> used;
  for (std::size_t i = 0; i < left.triangles.size(); ++i) {
    Triangle sorted = left.triangles[i];
    used.insert(sorted.begin(), sorted.end());
    std::sort(sorted.begin(), sorted.end());
    EXPECT_LT(sorted[0], sorted[1]);
    EXPECT_LT(sorted[1], sorted[2]);
    EXPECT_TRUE(seen.insert(sorted).second);
    const Vec3& now = left.vertices.at(static_cast<std::size_t>(left.triangles[i][0]));
    const auto corner = static_cast<std::size_t>(sphere.triangles.at(left.was[i])[0]);
    EXPECT_LT(distance(now, sphere.vertices[corner]), 0.3);
  }
  EXPECT_EQ(used.size(), left.vertices.size());
  for (const Vec3& vertex : left.vertices) EXPECT_NEAR(norm(vertex), 1, 0.05);
}

TEST(FewerTriangles, are_none_where_all_vertices_lie_in_one_place) {
  const SurfaceMesh cube = shapes::unit_cube();
  const std::vector<Vec3> one_place(cube.vertices.size(), Vec3{2, 3, 4});
  EXPECT_TRUE(fewer_triangles(one_place, cube.triangles, 3).triangles.empty());
}

TEST(FewerTriangles, are_the_same_each_time) {
  const SurfaceMesh torus = shapes::torus(0.4, 60, 50);
  const FewerTriangles once = fewer(torus, 900);
  const FewerTriangles again = fewer(torus, 900);
  EXPECT_EQ(once.vertices, again.vertices);
  EXPECT_EQ(once.triangles, again.triangles);
  EXPECT_EQ(once.was, again.was);
}

}  // namespace
}  // namespace tetfarm
