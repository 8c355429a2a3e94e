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

}  // namespace
}  // namespace tetfarm
