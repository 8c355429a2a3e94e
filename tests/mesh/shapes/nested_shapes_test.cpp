#include "mesh/shapes/nested_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "mesh/shapes/make_shape.h"

namespace tetfarm {
namespace {

std::ptrdiff_t triangles_of(const SurfaceMesh& mesh, std::int32_t patch) {
  return std::ranges::count(mesh.patch_of_triangle, patch);
}

/// Of the vertices of a patch, the least and the largest distance from the origin.
std::pair<double, double> distances(const SurfaceMesh& mesh, std::int32_t patch) {
  double least = HUGE_VAL;
  double largest = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.patch_of_triangle[t] != patch) continue;
    for (const std::int32_t v : mesh.triangles[t]) {
      const double far = norm(mesh.vertices[static_cast<std::size_t>(v)]);
      least = std::min(least, far);
      largest = std::max(largest, far);
    }
  }
  return {least, largest};
}

TEST(NestedShapes, of_two_spheres_have_the_radii_1_and_2) {
  const SurfaceMesh mesh = sphere_in_sphere(0.4);
  EXPECT_EQ(mesh.patch_names, (std::vector<std::string>{"outer", "inner"}));
  const auto outer = distances(mesh, 0);
  EXPECT_NEAR(outer.first, 2, 1e-14);
  EXPECT_NEAR(outer.second, 2, 1e-14);
  const auto inner = distances(mesh, 1);
  EXPECT_NEAR(inner.first, 1, 1e-14);
  EXPECT_NEAR(inner.second, 1, 1e-14);
  // 1.2046 radius / spacing parts an edge: 6 and 3 of them.
  EXPECT_EQ(triangles_of(mesh, 0), 20 * 36);
  EXPECT_EQ(triangles_of(mesh, 1), 20 * 9);
}

TEST(NestedShapes, of_a_sphere_in_a_box_leave_the_space_between_them) {
  const SurfaceMesh mesh = sphere_in_box(0.5);
  EXPECT_EQ(mesh.patch_names, (std::vector<std::string>{"outer", "inner"}));
  EXPECT_EQ(triangles_of(mesh, 0), 12 * 64) << "8 squares along each edge of length 4";
  EXPECT_EQ(triangles_of(mesh, 1), 20 * 4);
  const Box3 box = bounding_box(mesh.vertices);
  EXPECT_EQ(box.low, (Vec3{-2, -2, -2}));
  EXPECT_EQ(box.high, (Vec3{2, 2, 2}));
  const double volume = enclosed_volume(mesh.vertices, mesh.triangles);
  EXPECT_LT(volume, 64 - 2);
  EXPECT_GT(volume, 64 - 4.19) << "the sphere is a hole";
}

TEST(NestedShapes, have_two_parts_an_edge_at_least) {
  const SurfaceMesh balls = sphere_in_sphere(100);
  EXPECT_EQ(triangles_of(balls, 0), 20 * 4);
  EXPECT_EQ(triangles_of(balls, 1), 20 * 4);
  EXPECT_EQ(triangles_of(sphere_in_box(100), 0), 12 * 4);
}

/// What the refusal of a shape says.
std::string refusal(const std::string& name, const ShapeOptions& options) {
  try {
    make_shape(name, options);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "none";
}

TEST(MakeShapes, say_what_is_wrong_with_a_name_or_a_number) {
  EXPECT_EQ(refusal("teapot", {}), "teapot: unknown shape");
  EXPECT_EQ(refusal("sphere-in-sphere", {.spacing = 0}),
            "--spacing: the spacing 0 is too small for a length of 2.4092");
  EXPECT_EQ(refusal("sphere-in-box", {.spacing = 1e-5}),
            "--spacing: the spacing 1e-05 is too small for a length of 4");
  EXPECT_EQ(refusal("corner-reflector", {.spacing = -1}),
            "--spacing: the spacing -1 is too small for a length of 1");
  EXPECT_EQ(refusal("duct", {.spacing = 0}),
            "--spacing: the spacing 0 is too small for a length of 1");
  EXPECT_EQ(refusal("wing", {.spacing = 0.21}),
            "--spacing: the spacing must be positive and at most 0.2, or the wing has no shape; it "
            "is 0.21");
  EXPECT_EQ(refusal("wing", {.spacing = 0}),
            "--spacing: the spacing must be positive and at most 0.2, or the wing has no shape; it "
            "is 0");
  EXPECT_EQ(refusal("wing", {.growth = 0.009}),
            "--growth: the growth must be between 0.01 and 1; it is 0.009");
  EXPECT_EQ(refusal("wing", {.growth = 1.5}),
            "--growth: the growth must be between 0.01 and 1; it is 1.5");
  EXPECT_EQ(refusal("wing", {.spacing = 0.2, .growth = 1}), "none");
}

}  // namespace
}  // namespace tetfarm
