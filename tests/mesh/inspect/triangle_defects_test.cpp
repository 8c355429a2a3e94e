#include "mesh/inspect/triangle_defects.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/mesh/inspect/check_support.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> found(const SurfaceMesh& surface) {
  std::vector<std::string> result;
  for (const SurfaceDefect& defect : check_triangles(surface).defects)
    result.push_back(defect.kind);
  return result;
}

TEST(TriangleDefects, of_a_cube_are_none) {
  const TriangleCheck check = check_triangles(shapes::unit_cube());
  EXPECT_THAT(check.defects, IsEmpty());
  EXPECT_THAT(check.sieve.for_contact, testing::Each(1));
}

TEST(TriangleDefects, include_having_next_to_no_triangles) {
  SurfaceMesh mesh = shapes::tetrahedron();
  mesh.triangles.pop_back();
  EXPECT_THAT(found(mesh), ElementsAre("too few triangles"));
  EXPECT_THAT(found({}), ElementsAre("too few triangles"));
}

TEST(TriangleDefects, name_a_vertex_that_does_not_exist) {
  for (const std::int32_t v : {-1, 8, std::numeric_limits<std::int32_t>::max()}) {
    SurfaceMesh mesh = shapes::unit_cube();
    mesh.triangles[5][1] = v;
    const TriangleCheck check = check_triangles(mesh);
    ASSERT_THAT(found(mesh), ElementsAre("bad vertex number"));
    EXPECT_THAT(check.defects[0].triangles, ElementsAre(5));
    EXPECT_THAT(check.defects[0].message, HasSubstr(std::to_string(v)));
    EXPECT_EQ(check.sieve.for_edges[5], 0);
  }
}

TEST(TriangleDefects, name_coordinates_that_are_no_numbers) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           -std::numeric_limits<double>::infinity(), 1e61, 1e-61}) {
    SurfaceMesh mesh = shapes::unit_cube();
    mesh.vertices[3].y = bad;
    const TriangleCheck check = check_triangles(mesh);
    ASSERT_THAT(found(mesh), ElementsAre("bad coordinate"));
    for (const std::int64_t t : check.defects[0].triangles) {
      EXPECT_THAT(mesh.triangles[static_cast<std::size_t>(t)], testing::Contains(3));
      EXPECT_EQ(check.sieve.for_contact[static_cast<std::size_t>(t)], 0);
    }
  }
}

TEST(TriangleDefects, do_not_mind_a_bad_coordinate_that_no_triangle_uses) {
  SurfaceMesh mesh = shapes::unit_cube();
  mesh.vertices.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0});
  EXPECT_THAT(found(mesh), IsEmpty());
}

TEST(TriangleDefects, are_degenerate_only_when_the_area_is_exactly_zero) {
  SurfaceMesh mesh = shapes::unit_cube();
  const auto middle = static_cast<std::int32_t>(mesh.vertices.size());
  const Triangle first = mesh.triangles[0];
  const Vec3 a = mesh.vertices[static_cast<std::size_t>(first[0])];
  const Vec3 b = mesh.vertices[static_cast<std::size_t>(first[1])];
  mesh.vertices.push_back(0.5 * (a + b));
  mesh.triangles.push_back({first[0], first[1], middle});
  mesh.triangles.push_back({first[0], first[0], middle});
  const TriangleCheck check = check_triangles(mesh);
  ASSERT_THAT(found(mesh), ElementsAre("degenerate triangle"));
  EXPECT_THAT(check.defects[0].triangles, ElementsAre(12, 13));
  EXPECT_EQ(check.sieve.for_edges[12], 1) << "its edges still count";
  EXPECT_EQ(check.sieve.for_contact[12], 0);
  EXPECT_EQ(check.sieve.for_edges[13], 0);

  mesh.triangles.pop_back();
  mesh.vertices.back() += 1e-16 * Vec3{1, 1, 1};
  EXPECT_THAT(found(mesh), IsEmpty()) << "a sliver is no defect";
}

TEST(TriangleDefects, list_every_copy_of_a_duplicate) {
  SurfaceMesh mesh = shapes::unit_cube();
  const auto [a, b, c] = mesh.triangles[7];
  mesh.triangles.push_back({b, c, a});
  mesh.triangles.push_back({c, b, a});
  mesh.triangles.push_back(mesh.triangles[2]);
  const TriangleCheck check = check_triangles(mesh);
  ASSERT_THAT(found(mesh), ElementsAre("duplicate triangle"));
  EXPECT_THAT(check.defects[0].triangles, ElementsAre(2, 7, 12, 13, 14));
  EXPECT_THAT(check.defects[0].message,
              HasSubstr("2 triangles present more than once: triangle 2"));
  EXPECT_EQ(check.sieve.for_edges[7], 1);
  EXPECT_EQ(check.sieve.for_edges[12], 0);
}

}  // namespace
}  // namespace tetfarm
