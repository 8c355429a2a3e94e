#include "tests/support/remeshing_judge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr RemeshingDemands judged{.tolerance = 1e-3};

SurfaceMesh judged_box(int n) {
  SurfaceMesh box = shapes::box({0, 0, 0}, {1, 1, 1}, n);
  box.patch_names = {"wall", "lid"};
  box.patch_of_triangle.clear();
  for (const Triangle& t : box.triangles) {
    bool on_lid = true;
    for (const std::int32_t v : t)
      on_lid = on_lid && box.vertices[static_cast<std::size_t>(v)].z == 1;
    box.patch_of_triangle.push_back(on_lid ? 1 : 0);
  }
  return box;
}

/// Two regions, one on the other, and the sheet between them: the last 8 triangles, which turn
/// round the last vertex.
SurfaceMesh stacked_boxes() {
  SurfaceMesh s = judged_box(2);
  for (const Triangle& t : s.triangles) {
    double height = 0;
    for (const std::int32_t v : t) height += s.vertices[static_cast<std::size_t>(v)].z / 3;
    s.sides.push_back(height < 0.5 ? Sides{1, 0} : Sides{2, 0});
  }
  const std::vector<Vec3> ring = {{0, 0, 0.5}, {0.5, 0, 0.5}, {1, 0, 0.5}, {1, 0.5, 0.5},
                                  {1, 1, 0.5}, {0.5, 1, 0.5}, {0, 1, 0.5}, {0, 0.5, 0.5}};
  const auto number = [&s](const Vec3& p) {
    return static_cast<std::int32_t>(std::ranges::find(s.vertices, p) - s.vertices.begin());
  };
  const auto centre = static_cast<std::int32_t>(s.vertices.size());
  for (std::size_t k = 0; k < ring.size(); ++k) {
    s.triangles.push_back({centre, number(ring[k]), number(ring[(k + 1) % ring.size()])});
    s.patch_of_triangle.push_back(0);
    s.sides.push_back({1, 2});
  }
  s.vertices.push_back({0.5, 0.5, 0.5});
  s.region_names = {"lower", "upper"};
  return s;
}

std::vector<std::string> complaints_of(const SurfaceMesh& result) {
  return remeshing_complaints(judged_box(4), result, judged);
}

TEST(RemeshingJudge, has_no_complaint_of_the_same_shape_in_other_triangles) {
  EXPECT_THAT(complaints_of(judged_box(4)), IsEmpty());
  EXPECT_THAT(complaints_of(judged_box(3)), IsEmpty());
  EXPECT_THAT(complaints_of(judged_box(9)), IsEmpty());
  const SurfaceMesh torus = shapes::torus(0.3, 40, 20);
  EXPECT_THAT(remeshing_complaints(torus, torus, judged), IsEmpty());
}

TEST(RemeshingJudge, notices_a_hole) {
  SurfaceMesh open = judged_box(4);
  open.triangles.pop_back();
  open.patch_of_triangle.pop_back();
  EXPECT_THAT(complaints_of(open), Contains(HasSubstr("not closed")));
  EXPECT_THAT(complaints_of(open), Contains(HasSubstr("other than two triangles")));
}

TEST(RemeshingJudge, notices_a_turned_triangle) {
  SurfaceMesh turned = judged_box(4);
  std::swap(turned.triangles[5][0], turned.triangles[5][1]);
  EXPECT_THAT(complaints_of(turned), Contains(HasSubstr("not oriented")));
}

TEST(RemeshingJudge, notices_a_surface_that_is_inside_out) {
  SurfaceMesh turned = judged_box(4);
  for (Triangle& t : turned.triangles) std::swap(t[0], t[1]);
  EXPECT_THAT(complaints_of(turned), Contains(HasSubstr("volume")));
}

TEST(RemeshingJudge, notices_a_crossing) {
  SurfaceMesh crossed = judged_box(4);
  for (Vec3& v : crossed.vertices) {
    if (v == Vec3{0.5, 0.5, 1}) v.z = -0.5;
  }
  EXPECT_THAT(complaints_of(crossed), Contains(HasSubstr("self-intersection")));
}

TEST(RemeshingJudge, notices_another_genus_and_another_shell) {
  const SurfaceMesh ball = shapes::sphere({0, 0, 0}, 1, 2);
  const RemeshingDemands wide{.tolerance = 10, .area_share = 100};
  const SurfaceMesh torus = shapes::torus(0.3, 20, 10);
  EXPECT_THAT(remeshing_complaints(torus, ball, wide), Contains(HasSubstr("genus")));
  EXPECT_THAT(remeshing_complaints(ball, shapes::nested_spheres(2), wide),
              Contains(HasSubstr("other shells")));
}

TEST(RemeshingJudge, notices_a_corner_that_moved_by_less_than_the_tolerance) {
  SurfaceMesh moved = judged_box(4);
  for (Vec3& v : moved.vertices) {
    if (v == Vec3{1, 1, 1}) v.x -= 1e-6;
  }
  EXPECT_THAT(complaints_of(moved), testing::ElementsAre("1 corners are lost"));
}

TEST(RemeshingJudge, notices_a_dent_and_a_lost_detail) {
  SurfaceMesh dented = judged_box(4);
  for (Vec3& v : dented.vertices) {
    if (v == Vec3{0.5, 0.5, 1}) v.z -= 3e-3;
  }
  EXPECT_THAT(complaints_of(dented), Contains(HasSubstr("far from the input")));
  EXPECT_THAT(remeshing_complaints(dented, judged_box(1), judged),
              Contains(HasSubstr("of the input are far off")));
}

TEST(RemeshingJudge, notices_other_names_and_a_patch_that_grew) {
  SurfaceMesh renamed = judged_box(4);
  renamed.patch_names[1] = "top";
  EXPECT_THAT(complaints_of(renamed), Contains(HasSubstr("names")));
  SurfaceMesh grown = judged_box(4);
  for (std::int32_t& patch : grown.patch_of_triangle) {
    if (patch == 0) {
      patch = 1;
      break;
    }
  }
  EXPECT_THAT(complaints_of(grown), Contains(HasSubstr("area of patch 1")));
}

TEST(RemeshingJudge, lets_regions_meet_where_they_met) {
  EXPECT_THAT(remeshing_complaints(stacked_boxes(), stacked_boxes(), judged), IsEmpty());
  EXPECT_THAT(remeshing_complaints(judged_box(2), stacked_boxes(), judged),
              Contains(HasSubstr("other than two triangles")));
}

TEST(RemeshingJudge, notices_faults_of_the_sheet_between_regions) {
  SurfaceMesh torn = stacked_boxes();
  torn.triangles.pop_back();
  torn.patch_of_triangle.pop_back();
  torn.sides.pop_back();
  EXPECT_THAT(remeshing_complaints(stacked_boxes(), torn, judged),
              Contains(HasSubstr("not closed")));
  SurfaceMesh confused = stacked_boxes();
  std::swap(confused.sides.back()[0], confused.sides.back()[1]);
  EXPECT_THAT(remeshing_complaints(stacked_boxes(), confused, judged),
              Contains(HasSubstr("not closed")));
  SurfaceMesh bulged = stacked_boxes();
  bulged.vertices.back().z += 5e-3;
  EXPECT_THAT(remeshing_complaints(stacked_boxes(), bulged, judged),
              Contains(HasSubstr("far from the input")));
}

TEST(RemeshingJudge, notices_numbers_that_do_not_exist) {
  SurfaceMesh wrong = judged_box(4);
  wrong.triangles[0][0] = 1000000;
  EXPECT_THAT(complaints_of(wrong), Contains(HasSubstr("bad numbers")));
}

}  // namespace
}  // namespace tetfarm
