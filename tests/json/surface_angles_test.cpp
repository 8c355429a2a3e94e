#include "json/surface_angles.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

SurfaceMesh box_with_needles() {
  SurfaceMesh box = shapes::box({0, 0, 0}, {3, 3, 3}, 3);
  for (Vec3& v : box.vertices) {
    if (v == Vec3{1, 1, 3}) v.x = 2 - 1e-5;
  }
  return box;
}

TEST(SurfaceAngles, of_a_good_surface_nothing_is_remarked) {
  EXPECT_THAT(angle_remarks(surface_angles_of(shapes::unit_cube())), IsEmpty());
  EXPECT_THAT(angle_remarks(surface_angles_of(wire::JobStatus())), IsEmpty());
}

TEST(SurfaceAngles, small_ones_are_remarked_with_places_and_what_to_do) {
  const std::vector<std::string> remarks = angle_remarks(surface_angles_of(box_with_needles()));
  EXPECT_THAT(remarks, Contains(HasSubstr("of 108 triangles have an angle below 5 deg")));
  EXPECT_THAT(remarks, Contains(AllOf(HasSubstr("faces of the mesh have angles down to 0.000"),
                                      HasSubstr("remesh the surface near (1.99999"))));
}

TEST(SurfaceAngles, a_wedge_is_remarked_with_the_dihedral_angle_that_it_forces) {
  SurfaceMesh wedge;
  wedge.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 1, 0.1}};
  wedge.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  EXPECT_THAT(angle_remarks(surface_angles_of(wedge)),
              Contains(HasSubstr("forces a dihedral angle of ")));
}

TEST(SurfaceAngles, of_a_job_are_those_that_its_last_task_told) {
  wire::JobStatus status;
  auto& numbers = *status.mutable_numbers();
  numbers["surface_triangles"] = 2240;
  numbers["surface_smallest_angle_deg"] = 0.00022;
  numbers["surface_triangles_below_1_deg"] = 13;
  numbers["surface_triangles_below_5_deg"] = 34;
  numbers["surface_worst_1_triangle"] = 17;
  numbers["surface_worst_1_angle_deg"] = 0.00022;
  numbers["surface_worst_1_y"] = 2.5;
  numbers["forced_dihedral_deg"] = 40;
  (*status.mutable_texts())["surface_worst_1_patch"] = "wing";
  const SurfaceAngles angles = surface_angles_of(status);
  const nlohmann::ordered_json json = surface_angles_json(angles);
  EXPECT_EQ(json["triangles_below_1_deg"], 13);
  EXPECT_EQ(json["triangles_below_5_deg"], 34);
  EXPECT_EQ(json["smallest_angle_deg"], 0.00022);
  ASSERT_EQ(json["worst"].size(), 1U);
  EXPECT_EQ(json["worst"][0]["triangle"], 17);
  EXPECT_EQ(json["worst"][0]["at"][1], 2.5);
  EXPECT_EQ(json["worst"][0]["patch"], "wing");
  EXPECT_THAT(
      angle_remarks(angles),
      Contains(HasSubstr("34 of 2240 triangles have an angle below 5 deg, 13 of them below "
                         "1 deg; the smallest: triangle 17 with 0.00022 deg near (0, 2.5, 0)"
                         " in patch \"wing\"")));
}

SurfaceAngles told_angles(double forced_deg) {
  SurfaceAngles angles;
  angles.forced = {forced_deg, {1, 2, 3}};
  angles.triangles.triangles = 100;
  angles.triangles.smallest_deg = 0.5;
  angles.triangles.below_1_deg = 1;
  angles.triangles.below_5_deg = 2;
  angles.triangles.worst = {{17, 0.5, {4, 5, 6}, "wing"}, {18, 0.75, {7, 8, 9}, ""}};
  return angles;
}

TEST(SurfaceAngles, are_remarked_in_whole_sentences) {
  const std::vector<std::string> remarks = angle_remarks(told_angles(12));
  ASSERT_EQ(remarks.size(), 3U);
  EXPECT_EQ(remarks[1],
            "faces of the mesh have angles down to 0.50 deg, as they are the surface's own "
            "triangles; for better elements, remesh the surface near (4, 5, 6), patch \"wing\"");
  EXPECT_EQ(remarks[2],
            "the edge between two triangles forces a dihedral angle of 12.00 deg or less near "
            "(1, 2, 3)");
  SurfaceAngles without_patch = told_angles(20);
  without_patch.triangles.worst.front().patch = "";
  const std::vector<std::string> fewer = angle_remarks(without_patch);
  ASSERT_EQ(fewer.size(), 2U) << "20 degrees are no small angle";
  EXPECT_TRUE(fewer[1].ends_with("near (4, 5, 6)")) << fewer[1];
  EXPECT_EQ(angle_remarks(told_angles(19.99)).size(), 3U);
}

TEST(SurfaceAngles, are_told_to_programs_each_with_its_place) {
  EXPECT_EQ(surface_angles_json(told_angles(12)).dump(),
            R"({"smallest_angle_deg":0.5,"triangles_below_1_deg":1,"triangles_below_5_deg":2,)"
            R"("forced_dihedral_deg":12.0,"forced_at":[1.0,2.0,3.0],"worst":[)"
            R"({"triangle":17,"angle_deg":0.5,"at":[4.0,5.0,6.0],"patch":"wing"},)"
            R"({"triangle":18,"angle_deg":0.75,"at":[7.0,8.0,9.0],"patch":""}]})");
}

TEST(SurfaceAngles, of_a_job_has_as_many_of_the_worst_as_were_told) {
  wire::JobStatus status;
  auto& numbers = *status.mutable_numbers();
  numbers["surface_triangles"] = 100;
  numbers["forced_dihedral_deg"] = 40;
  numbers["forced_x"] = 1;
  numbers["forced_y"] = 2;
  numbers["forced_z"] = 3;
  for (int i = 1; i <= 3; ++i) {
    const std::string which = "surface_worst_" + std::to_string(i);
    numbers[which + "_triangle"] = 10 + i;
    numbers[which + "_angle_deg"] = 0.5 * i;
    numbers[which + "_z"] = i;
  }
  const SurfaceAngles angles = surface_angles_of(status);
  EXPECT_EQ(angles.forced.at_most_deg, 40);
  EXPECT_EQ(angles.forced.at, (Vec3{1, 2, 3}));
  EXPECT_EQ(angles.triangles.triangles, 100);
  ASSERT_EQ(angles.triangles.worst.size(), 3U);
  EXPECT_EQ(angles.triangles.worst[2].triangle, 13);
  EXPECT_EQ(angles.triangles.worst[2].angle_deg, 1.5);
  EXPECT_EQ(angles.triangles.worst[2].at, (Vec3{0, 0, 3}));
}

}  // namespace
}  // namespace tetfarm
