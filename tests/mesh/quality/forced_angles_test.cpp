#include "mesh/quality/forced_angles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

/// Of a wedge of an angle about the edge from the origin to `end`: the triangles on its two sides,
/// normals outwards, with the nodes from `first` on.
NumberedPart wedge(double angle_deg, const Vec3& end, std::int64_t first, std::int32_t region) {
  const double angle = angle_deg * std::numbers::pi / 180;
  NumberedPart part;
  part.region = region;
  part.nodes = {{0, 0, 0}, end, {0, 1, 0}, {0, std::cos(angle), std::sin(angle)}};
  for (std::int64_t i = 0; i < 4; ++i) part.local2global.push_back(first + i);
  part.faces = {{0, 2, 1}, {0, 1, 3}};
  part.patch_of_face = {0, 0};
  return part;
}

ForcedDihedral forced_of(const std::vector<NumberedPart>& parts) {
  const TempFolder folder;
  ForcedAngles angles(folder.path(), 0);
  for (const NumberedPart& part : parts) angles.add(part);
  return angles.finish();
}

TEST(ForcedAngles, are_the_smallest_between_two_triangles_and_lie_at_the_middle_of_their_edge) {
  const ForcedDihedral forced = forced_of(
      {wedge(50, {2, 0, 0}, 0, 1), wedge(20, {4, 0, 0}, 10, 1), wedge(30, {6, 0, 0}, 20, 1)});
  EXPECT_NEAR(forced.at_most_deg, 20, 1e-9);
  EXPECT_EQ(forced.at, (Vec3{2, 0, 0}));
}

TEST(ForcedAngles, of_equal_ones_are_that_of_the_first_region_and_nodes) {
  EXPECT_EQ(forced_of({wedge(20, {4, 0, 0}, 10, 2), wedge(20, {6, 0, 0}, 20, 1),
                       wedge(20, {8, 0, 0}, 30, 1)})
                .at,
            (Vec3{3, 0, 0}));
}

TEST(ForcedAngles, are_of_the_triangles_of_one_region_whatever_part_has_them) {
  const NumberedPart both = wedge(20, {2, 0, 0}, 0, 1);
  NumberedPart one = both;
  NumberedPart other = both;
  one.faces.pop_back();
  one.patch_of_face.pop_back();
  other.faces.erase(other.faces.begin());
  other.patch_of_face.pop_back();
  EXPECT_EQ(forced_of({one, other}).at_most_deg, forced_of({both}).at_most_deg);
  EXPECT_NEAR(forced_of({other, one}).at_most_deg, 20, 1e-9);
  other.region = 2;
  EXPECT_EQ(forced_of({one, other}).at_most_deg, ForcedDihedral().at_most_deg);
  other.region_of_face = {1};
  EXPECT_NEAR(forced_of({one, other}).at_most_deg, 20, 1e-9);
}

TEST(ForcedAngles, are_not_of_an_edge_with_one_triangle_or_three_or_two_that_run_the_same_way) {
  NumberedPart part = wedge(20, {2, 0, 0}, 0, 1);
  part.nodes.push_back({2, 0, -3});
  part.local2global.push_back(4);
  part.faces.push_back({0, 1, 4});
  part.patch_of_face.push_back(0);
  EXPECT_EQ(forced_of({part}).at_most_deg, ForcedDihedral().at_most_deg) << "three";
  part.faces = {{0, 2, 1}};
  EXPECT_EQ(forced_of({part}).at_most_deg, ForcedDihedral().at_most_deg) << "one";
  part.faces = {{0, 1, 2}, {0, 1, 3}};
  EXPECT_EQ(forced_of({part}).at_most_deg, ForcedDihedral().at_most_deg) << "the same way";
  EXPECT_EQ(forced_of({}).at, (Vec3{0, 0, 0}));
}

}  // namespace
}  // namespace tetfarm
