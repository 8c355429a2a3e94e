#include "mesh/shapes/refined_surface.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>

#include "base/array_index.h"
#include "base/error.h"
#include "mesh/core/triangle_angles.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/shapes/make_shape.h"
#include "tests/mesh/inspect/check_support.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

double longest_edge_of(const SurfaceMesh& mesh) {
  double longest = 0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      longest =
          std::max(longest, distance(mesh.vertices[at(t[i])], mesh.vertices[at(t[(i + 1) % 3])]));
    }
  }
  return longest;
}

double smallest_angle_of(const SurfaceMesh& mesh) {
  double smallest = 180;
  for (const auto& [a, b, c] : mesh.triangles) {
    smallest = std::min(smallest, smallest_angle_deg(mesh.vertices[at(a)], mesh.vertices[at(b)],
                                                     mesh.vertices[at(c)]));
  }
  return smallest;
}

std::string refusal_of(const SurfaceMesh& mesh, double longest_edge) {
  try {
    refined_surface(mesh, longest_edge);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(RefinedSurface, is_closed_has_no_edge_that_is_too_long_and_no_angle_below_half_the_smallest) {
  // Edges from 0.1 to a few units in one surface: neighbours are refined differently.
  const SurfaceMesh wing = make_shape("wing", {.spacing = 0.15, .growth = 0.5});
  for (const double longest_edge : {3.0, 1.0, 0.7}) {
    const SurfaceMesh fine = refined_surface(wing, longest_edge);
    EXPECT_LE(longest_edge_of(fine), longest_edge);
    EXPECT_GE(smallest_angle_of(fine), 0.499 * smallest_angle_of(wing));
    const CheckedSurface checked = check_surface(fine);
    EXPECT_THAT(kinds(checked.report), IsEmpty()) << longest_edge;
    EXPECT_EQ(checked.report.unused_vertices, 0);
    EXPECT_NEAR(checked.report.volume, enclosed_volume(wing.vertices, wing.triangles), 1e-9);
  }
}

TEST(RefinedSurface, keeps_vertices_patches_and_what_is_fine_enough) {
  const SurfaceMesh wing = make_shape("wing", {.spacing = 0.15, .growth = 0.5});
  const SurfaceMesh fine = refined_surface(wing, 1);
  ASSERT_GT(fine.vertices.size(), wing.vertices.size());
  EXPECT_TRUE(std::equal(wing.vertices.begin(), wing.vertices.end(), fine.vertices.begin()));
  EXPECT_EQ(fine.patch_names, wing.patch_names);
  std::map<std::int32_t, double> area;
  for (const auto& [mesh, sign] : {std::pair{&wing, 1.0}, {&fine, -1.0}}) {
    for (std::size_t t = 0; t < mesh->triangles.size(); ++t) {
      const auto& [a, b, c] = mesh->triangles[t];
      area[mesh->patch_of_triangle[t]] +=
          sign * 0.5 *
          norm(cross(mesh->vertices[at(b)] - mesh->vertices[at(a)],
                     mesh->vertices[at(c)] - mesh->vertices[at(a)]));
    }
  }
  ASSERT_EQ(area.size(), 3U);
  for (const auto& [patch, rest] : area) EXPECT_NEAR(rest, 0, 1e-9) << patch;
  const SurfaceMesh same = refined_surface(wing, 100);
  EXPECT_EQ(same.triangles, wing.triangles);
  EXPECT_EQ(same.patch_of_triangle, wing.patch_of_triangle);
}

TEST(RefinedSurface, halves_an_edge_alike_on_all_its_triangles_and_keeps_their_sides) {
  SurfaceMesh three;  // triangles on one edge, as where three regions meet
  three.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 0.1, 0}, {0.5, 0, 0.3}, {0.5, -0.2, 0}};
  three.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  three.sides = {{1, 2}, {2, 3}, {3, 1}};
  const SurfaceMesh fine = refined_surface(three, 0.9);
  EXPECT_EQ(fine.vertices.size(), 6U);
  EXPECT_EQ(fine.triangles.size(), 6U);
  EXPECT_EQ(fine.sides, (std::vector<Sides>{{1, 2}, {1, 2}, {2, 3}, {2, 3}, {3, 1}, {3, 1}}));
  EXPECT_THAT(fine.patch_of_triangle, IsEmpty());
}

TEST(RefinedSurface, ends_where_doubles_have_no_midpoint_left) {
  SurfaceMesh far = shapes::unit_cube();
  for (Vec3& p : far.vertices) p = p + Vec3{0x1p52, 0, 0};
  // Along x neighbouring doubles are 1 apart: edges along y and z are halved, others as far as they
  // go.
  const SurfaceMesh fine = refined_surface(far, 0.4);
  EXPECT_GT(fine.triangles.size(), 12U);
  EXPECT_LT(fine.triangles.size(), 1000U);
  for (const Vec3& p : fine.vertices) EXPECT_TRUE(p.x == 0x1p52 || p.x == 0x1p52 + 1);
}

TEST(RefinedSurface, is_refused_at_once_where_there_would_be_too_many_triangles) {
  const SurfaceMesh cube = shapes::unit_cube();
  EXPECT_THAT(refusal_of(cube, 1e-5), HasSubstr("--max-edge: edges of at most 1e-05 would make "
                                                "more than 100000000 triangles"));
  EXPECT_THAT(refusal_of(cube, 1e-300), HasSubstr("more than 100000000 triangles"));
  EXPECT_THAT(refusal_of(cube, 0), HasSubstr("--max-edge: edges of at most 0 make no sense"));
  EXPECT_THAT(refusal_of(cube, -1), HasSubstr("make no sense"));
}

}  // namespace
}  // namespace tetfarm
