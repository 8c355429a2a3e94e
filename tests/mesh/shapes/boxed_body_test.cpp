#include "mesh/shapes/boxed_body.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/shapes/box_and_sphere.h"
#include "tests/mesh/inspect/check_support.h"

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

SurfaceMesh slab() { return box_surface({{0, 1, 2}, {4, 3, 2.5}}, 3); }

std::string refusal_of(const SurfaceMesh& body, const FittingBox& box) {
  try {
    boxed_body(body, box);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(BoxedBody, is_the_space_between_a_body_and_a_box_that_fits_it) {
  const SurfaceMesh mesh = boxed_body(slab(), {0.5, 0.25});
  EXPECT_EQ(bounding_box(mesh.vertices).low, (Vec3{-0.5, 0.5, 1.5}));
  EXPECT_EQ(bounding_box(mesh.vertices).high, (Vec3{4.5, 3.5, 3}));
  EXPECT_THAT(mesh.patch_names, ElementsAre("surface", "outer"));
  EXPECT_NEAR(enclosed_volume(mesh.vertices, mesh.triangles), 5 * 3 * 1.5 - 4 * 2 * 0.5, 1e-12);
  const CheckedSurface checked = check_surface(mesh);
  EXPECT_THAT(kinds(checked.report), IsEmpty());
  EXPECT_NEAR(checked.report.volume, 5 * 3 * 1.5 - 4 * 2 * 0.5, 1e-12);
  EXPECT_EQ(checked.surface.triangles, mesh.triangles) << "none was the wrong way round";
}

TEST(BoxedBody, has_squares_of_the_spacing_along_each_axis_and_the_body_s_own_triangles_first) {
  const SurfaceMesh body = slab();
  const SurfaceMesh mesh = boxed_body(body, {0.5, 0.25});
  const std::size_t outer = mesh.triangles.size() - body.triangles.size();
  EXPECT_EQ(outer, 2 * 2 * (20 * 12 + 12 * 6 + 6 * 20U));
  const auto& [a, b, c] = body.triangles[5];
  EXPECT_EQ(mesh.triangles[5], (Triangle{a, c, b}));
  EXPECT_EQ(mesh.patch_of_triangle[body.triangles.size() - 1], 0);
  EXPECT_EQ(mesh.patch_of_triangle[body.triangles.size()], 1);
}

TEST(BoxedBody, refuses_what_makes_no_box) {
  EXPECT_THAT(refusal_of({}, {1, 1}), HasSubstr("--box: there is no body"));
  EXPECT_THAT(refusal_of(slab(), {0, 1}), HasSubstr("--box: the margin must be positive; it is 0"));
  EXPECT_THAT(refusal_of(slab(), {1, 0}), HasSubstr("--box-size: the spacing 0 is too small"));
  EXPECT_THAT(refusal_of(boxed_body(slab(), {1, 1}), {1, 1}), HasSubstr("has a patch \"outer\""));
}

}  // namespace
}  // namespace tetfarm
