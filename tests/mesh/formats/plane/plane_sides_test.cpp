#include "mesh/formats/plane/plane_sides.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/mesh/formats/plane/square_ring.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(PlaneSides, are_upper_triangular_inside_and_patch_after_patch_on_the_border) {
  const PlaneSides sides = sides_of(square_ring());
  ASSERT_EQ(sides.inner.size(), 8U);
  ASSERT_EQ(sides.border.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_LT(sides.inner[i].triangle, sides.inner[i].neighbour);
    if (i == 0) continue;
    const InnerSide& before = sides.inner[i - 1];
    EXPECT_LT(std::pair(before.triangle, before.neighbour),
              std::pair(sides.inner[i].triangle, sides.inner[i].neighbour));
    EXPECT_LE(sides.border[i - 1].patch, sides.border[i].patch);
  }
}

TEST(PlaneSides, have_their_first_triangle_on_the_left) {
  const PlaneMesh mesh = square_ring();
  const PlaneSides sides = sides_of(mesh);
  const auto runs_in = [&](std::int32_t triangle, std::int32_t a, std::int32_t b) {
    const auto& n = mesh.triangles[static_cast<std::size_t>(triangle)];
    return (n[0] == a && n[1] == b) || (n[1] == a && n[2] == b) || (n[2] == a && n[0] == b);
  };
  for (const InnerSide& side : sides.inner) {
    EXPECT_TRUE(runs_in(side.triangle, side.a, side.b));
    EXPECT_TRUE(runs_in(side.neighbour, side.b, side.a));
  }
  for (const OuterSide& side : sides.border) EXPECT_TRUE(runs_in(side.triangle, side.a, side.b));
}

TEST(PlaneSides, without_a_patch_in_the_mesh_are_on_patch_0) {
  PlaneMesh mesh = square_ring();
  mesh.edges.clear();
  mesh.patches.clear();
  for (const OuterSide& side : sides_of(mesh).border) EXPECT_EQ(side.patch, 0);
}

TEST(PlaneSides, of_three_triangles_are_refused) {
  PlaneMesh mesh = square_ring();
  mesh.triangles.push_back({0, 5, 3});
  EXPECT_THAT(error_text_of<InvalidInput>([&] { sides_of(mesh); }),
              HasSubstr("ring: nodes 1 and 6 are a side of 3 triangles"));
}

TEST(BorderPatches, have_plain_names_or_their_numbers) {
  const PlaneMesh mesh = square_ring();
  std::vector<std::string> names;
  for (const PlanePatch& patch : border_patches(mesh, sides_of(mesh))) names.push_back(patch.name);
  EXPECT_THAT(names, ElementsAre("inlet", "patch_5", "the_body"));
}

TEST(BorderPatches, that_bound_holes_alone_are_told_from_others) {
  PlaneMesh mesh = square_ring();
  const auto holes = [&] {
    const PlaneSides sides = sides_of(mesh);
    return bound_holes(mesh, sides, border_patches(mesh, sides));
  };
  EXPECT_THAT(holes(), ElementsAre(false, false, true));
  mesh.patches = {3, 5, 5, 5, 9, 9, 9, 5, 11};  // patch 5 is on both now
  EXPECT_THAT(holes(), ElementsAre(false, false, true));
  mesh.patches = {9, 9, 9, 9, 3, 3, 3, 3, 11};
  EXPECT_THAT(holes(), ElementsAre(true, false));
}

}  // namespace
}  // namespace tetfarm
