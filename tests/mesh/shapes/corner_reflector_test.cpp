#include "mesh/shapes/corner_reflector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "base/error.h"

namespace tetfarm {
namespace {

double area(const SurfaceMesh& mesh, std::int32_t patch) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.patch_of_triangle[t] != patch) continue;
    const auto p = [&](std::size_t i) {
      return mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][i])];
    };
    sum += 0.5 * norm(cross(p(1) - p(0), p(2) - p(0)));
  }
  return sum;
}

Box3 box_of(const SurfaceMesh& mesh, std::int32_t patch) {
  Box3 box;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.patch_of_triangle[t] != patch) continue;
    for (const std::int32_t v : mesh.triangles[t]) {
      box.add(mesh.vertices[static_cast<std::size_t>(v)]);
    }
  }
  return box;
}

TEST(CornerReflector, is_a_cube_without_an_octant_in_a_box_three_times_as_large) {
  const SurfaceMesh mesh = corner_reflector(0.5);
  EXPECT_EQ(mesh.patch_names, (std::vector<std::string>{"outer", "reflector", "body"}));
  EXPECT_NEAR(area(mesh, 0), 6 * 36, 1e-9);
  EXPECT_NEAR(area(mesh, 1), 3, 1e-12) << "the faces of the cavity";
  EXPECT_NEAR(area(mesh, 2), 24 - 3, 1e-12);
  EXPECT_EQ(box_of(mesh, 0).low, (Vec3{-3, -3, -3}));
  EXPECT_EQ(box_of(mesh, 0).high, (Vec3{3, 3, 3}));
  EXPECT_EQ(box_of(mesh, 1).low, (Vec3{0, 0, 0}));
  EXPECT_EQ(box_of(mesh, 1).high, (Vec3{1, 1, 1}));
  EXPECT_EQ(box_of(mesh, 2).low, (Vec3{-1, -1, -1}));
  EXPECT_EQ(box_of(mesh, 2).high, (Vec3{1, 1, 1}));
  EXPECT_NEAR(enclosed_volume(mesh.vertices, mesh.triangles), 216 - 7, 1e-9);
}

TEST(CornerReflector, has_squares_of_the_spacing_two_triangles_each) {
  for (const auto& [spacing, n, outer] :
       {std::tuple{1.0, 1, 6}, {0.5, 2, 12}, {0.34, 3, 18}, {0.26, 4, 23}, {7.0, 1, 1}}) {
    const SurfaceMesh mesh = corner_reflector(spacing);
    std::map<std::int32_t, int> triangles;
    for (const std::int32_t patch : mesh.patch_of_triangle) ++triangles[patch];
    EXPECT_EQ(triangles[0], 12 * outer * outer) << spacing;
    EXPECT_EQ(triangles[1], 3 * 2 * n * n) << spacing;
    EXPECT_EQ(triangles[2], 21 * 2 * n * n) << spacing;
  }
}

TEST(CornerReflector, has_diagonals_from_the_corners_of_its_faces_towards_their_middle) {
  // No edge cuts a corner of the cavity off: all three faces there have edges along the diagonal.
  const SurfaceMesh mesh = corner_reflector(0.25);
  const auto at_corner = [&](const Triangle& t) {
    return std::ranges::count_if(t, [&](std::int32_t v) {
      return mesh.vertices[static_cast<std::size_t>(v)] == Vec3{0, 0, 0};
    });
  };
  int triangles = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.patch_of_triangle[t] == 1 && at_corner(mesh.triangles[t]) > 0) ++triangles;
  }
  EXPECT_EQ(triangles, 6) << "two for each of its three faces";
}

TEST(CornerReflector, refuses_a_spacing_that_is_none) {
  EXPECT_THROW(corner_reflector(0), UsageError);
  EXPECT_THROW(corner_reflector(-0.1), UsageError);
  EXPECT_THROW(corner_reflector(1e-6), UsageError);
}

}  // namespace
}  // namespace tetfarm
