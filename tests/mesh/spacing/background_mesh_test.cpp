#include "mesh/spacing/background_mesh.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

Box3 box_to(double size) {
  Box3 box;
  box.add(Vec3{0, 0, 0});
  box.add(Vec3{size, size, size});
  return box;
}

SourceDemand point_demand(const Vec3& at, double spacing) {
  return source_demand({{{at, spacing, 0.01, 0.02}}}, 100);
}

TEST(BackgroundMesh, is_the_background_without_sources) {
  const BackgroundMesh mesh({}, box_to(2), 0.5, 0.3);
  EXPECT_DOUBLE_EQ(mesh.at({0.3, 0.7, 1.9}), 0.5);
  EXPECT_DOUBLE_EQ(mesh.at({0, 0, 0}), 0.5);
  EXPECT_DOUBLE_EQ(mesh.at({2, 2, 1}), 0.5);
}

TEST(BackgroundMesh, has_the_spacing_of_its_nodes) {
  const BackgroundMesh mesh({point_demand({1, 1, 1}, 0.1), point_demand({0.5, 1, 1.5}, 0.2)},
                            box_to(2), 1, 100);
  EXPECT_DOUBLE_EQ(mesh.at({1, 1, 1}), 0.1);
  EXPECT_DOUBLE_EQ(mesh.at({0.5, 1, 1.5}), 0.2);
}

TEST(BackgroundMesh, is_linear_between_nodes) {
  // The centre of the box sees each corner: linear along the diagonal.
  const BackgroundMesh mesh({point_demand({1, 1, 1}, 0.1)}, box_to(2), 1, 100);
  EXPECT_NEAR(mesh.at({0.5, 0.5, 0.5}), 0.55, 1e-12);
  EXPECT_NEAR(mesh.at({1.75, 0.25, 1.75}), 0.775, 1e-12);
}

TEST(BackgroundMesh, takes_the_smallest_of_sources_at_one_place) {
  for (const double first : {0.1, 0.4}) {
    const BackgroundMesh mesh(
        {point_demand({1, 1, 1}, first), point_demand({1, 1, 1}, 0.5 - first)}, box_to(2), 1, 100);
    EXPECT_DOUBLE_EQ(mesh.at({1, 1, 1}), 0.1);
  }
}

TEST(BackgroundMesh, limits_its_nodes_by_the_growth_between_them) {
  const BackgroundMesh mesh({point_demand({1, 1, 1}, 0.1), point_demand({1, 1, 1.5}, 0.9)},
                            box_to(2), 1, 0.2);
  EXPECT_DOUBLE_EQ(mesh.at({1, 1, 1.5}), 0.2);
}

TEST(BackgroundMesh, fills_the_space_between_sources_when_asked) {
  SpacingOptions options;
  options.background = 0.4;
  options.inherit_surface = false;
  for (const double x : {0.2, 0.8}) {
    for (const double y : {0.2, 0.8}) {
      options.sources.push_back({{{{x, y, 0.2}, 0.1, 0.02, 0.05}, {{x, y, 0.8}, 0.1, 0.02, 0.05}}});
    }
  }
  const Vec3 between{0.5, 0.5, 0.5};
  const SurfaceMesh cube = shapes::unit_cube();
  EXPECT_GT(make_spacing_field(cube, options).at(between), 0.17);
  options.background_mesh = true;
  const SpacingField field = make_spacing_field(cube, options);
  EXPECT_NEAR(field.at(between), 0.1, 0.01);
  EXPECT_GT(field.at({0, 0, 0}), 0.1);
  EXPECT_LE(field.at({0, 0, 0}), 0.1 + 0.33 * 0.35);
}

}  // namespace
}  // namespace tetfarm
