#include "mesh/inspect/small_angles.h"

#include <gmock/gmock.h>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

/// A box of 3 x 3 squares a face, on the top of which a vertex has come near to its neighbour.
SurfaceMesh box_with_needles(double gap) {
  SurfaceMesh box = shapes::box({0, 0, 0}, {3, 3, 3}, 3);
  for (Vec3& v : box.vertices) {
    if (v == Vec3{1, 1, 3}) v.x = 2 - gap;
  }
  box.patch_of_triangle.assign(box.triangles.size(), 0);
  box.patch_names = {"hull"};
  return box;
}

TEST(SmallAngles, of_a_good_surface_are_none) {
  const SmallAngles angles = small_angles(shapes::sphere({0, 0, 0}, 1, 2));
  EXPECT_EQ(angles.triangles, 320);
  EXPECT_EQ(angles.below_1_deg, 0);
  EXPECT_EQ(angles.below_5_deg, 0);
  EXPECT_GT(angles.smallest_deg, 40);
  EXPECT_THAT(angles.worst, IsEmpty());
  EXPECT_THAT(small_angles_text(angles), IsEmpty());
}

TEST(SmallAngles, are_counted_below_5_and_below_1_degree) {
  const SmallAngles somewhat = small_angles(box_with_needles(0.05));
  EXPECT_EQ(somewhat.below_1_deg, 0);
  EXPECT_GE(somewhat.below_5_deg, 2);
  const SmallAngles very = small_angles(box_with_needles(1e-5));
  EXPECT_EQ(very.below_1_deg, very.below_5_deg);
  EXPECT_GE(very.below_1_deg, 2);
  EXPECT_LT(very.smallest_deg, 6e-4);
}

TEST(SmallAngles, of_triangles_that_are_left_out_do_not_count) {
  const SurfaceMesh box = box_with_needles(0.05);
  const SmallAngles all = small_angles(box);
  ASSERT_GE(all.worst.size(), 2U);
  std::vector<bool> left_out(box.triangles.size(), false);
  left_out[static_cast<std::size_t>(all.worst[0].triangle)] = true;
  const SmallAngles rest = small_angles(box, left_out);
  EXPECT_EQ(rest.triangles, all.triangles);
  EXPECT_EQ(rest.below_5_deg, all.below_5_deg - 1);
  EXPECT_EQ(rest.worst[0].triangle, all.worst[1].triangle);
  EXPECT_EQ(rest.smallest_deg, all.worst[1].angle_deg);
}

TEST(SmallAngles, the_worst_come_first_with_their_numbers_places_and_patches) {
  const SurfaceMesh box = box_with_needles(1e-5);
  const SmallAngles angles = small_angles(box);
  ASSERT_FALSE(angles.worst.empty());
  EXPECT_LE(angles.worst.size(), worst_kept);
  const SmallAngle& worst = angles.worst.front();
  EXPECT_EQ(worst.angle_deg, angles.smallest_deg);
  EXPECT_NEAR(distance(worst.at, {2, 1, 3}), 0, 1e-4);
  EXPECT_EQ(worst.patch, "hull");
  const std::string text = small_angles_text(angles);
  EXPECT_THAT(text, HasSubstr("of 108 triangles have an angle below 5 deg"));
  EXPECT_THAT(text, HasSubstr("of them below 1 deg"));
  EXPECT_THAT(text, HasSubstr("triangle " + std::to_string(worst.triangle) + " with 0.000"));
  EXPECT_THAT(text, HasSubstr("patch \"hull\""));
}

TEST(SmallAngles, the_name_of_a_patch_commands_no_terminal) {
  SurfaceMesh box = box_with_needles(1e-5);
  box.patch_names = {"a\x1b[31m\n" + std::string(1000, 'x')};
  const SmallAngles angles = small_angles(box);
  ASSERT_THAT(angles.worst, Not(IsEmpty()));
  EXPECT_THAT(angles.worst.front().patch, HasSubstr("a?[31m?"));
  EXPECT_THAT(angles.worst.front().patch, SizeIs(60));
}

TEST(SmallAngles, lie_near_the_middle_of_the_shortest_edge_whichever_it_is) {
  SurfaceMesh mesh;
  mesh.vertices = {{0, 0, 0}, {0, 0.02, 0}, {1, 0, 0}};
  for (const Triangle& t : {Triangle{0, 1, 2}, Triangle{2, 0, 1}, Triangle{1, 2, 0}}) {
    mesh.triangles = {t};
    const SmallAngles found = small_angles(mesh);
    ASSERT_EQ(found.worst.size(), 1U);
    EXPECT_EQ(found.worst[0].at, (Vec3{0, 0.01, 0}));
  }
}

}  // namespace
}  // namespace tetfarm
