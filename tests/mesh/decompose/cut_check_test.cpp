#include "mesh/decompose/cut_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/decompose/surface_contact.h"
#include "tests/mesh/decompose/flat_cut.h"

namespace tetfarm {
namespace {

TEST(CutCheck, sees_a_shell_on_the_wrong_side) {
  FlatCut cut = cut_at_plate(0.51, 0.6);
  for (std::size_t i = cut.mesh.rim_vertices.size(); i < cut.mesh.heights.size(); ++i) {
    cut.mesh.heights[i] = 0.3;
  }
  EXPECT_FALSE(
      shells_are_on_their_sides(cut.mesh, cut.subdomain, cut.colours, cut.topology.triangle2shell));
}

TEST(CutCheck, sees_an_intersection) {
  FlatCut cut = cut_at_plate(0.51, 0.6);
  for (std::size_t i = cut.mesh.rim_vertices.size(); i < cut.mesh.heights.size(); ++i) {
    cut.mesh.heights[i] = 0.05;
  }
  const auto nearby = find_nearby_surface(cut.mesh, cut.subdomain, cut.topology, 2);
  EXPECT_EQ(judge_contacts(find_contacts(cut.mesh, cut.subdomain, cut.topology, nearby, 0.4)),
            "intersection");
}

TEST(CutCheck, sees_a_shell_that_was_coloured_as_if_it_lay_on_the_other_side) {
  FlatCut cut = cut_at_plate(0.6, 0.8);
  const auto is_right = [&cut] {
    return shells_are_on_their_sides(cut.mesh, cut.subdomain, cut.colours,
                                     cut.topology.triangle2shell);
  };
  EXPECT_TRUE(is_right());
  const std::int32_t plate = cut.topology.triangle2shell.back();
  for (std::size_t t = 0; t < cut.colours.size(); ++t) {
    if (cut.topology.triangle2shell[t] == plate) cut.colours[t] = Side::left;
  }
  EXPECT_FALSE(is_right());
}

TEST(CutCheck, sees_a_cavity_on_another_side_than_the_body_round_it) {
  // Beside the cut, so that its heights say nothing of their sides.
  FlatCut cut = cap_of_sphere();
  const auto add = [&](const SurfaceMesh& shell, Side side) {
    const auto first = static_cast<std::int32_t>(cut.subdomain.vertices.size());
    const std::int32_t number = 1 + *std::max_element(cut.topology.triangle2shell.begin(),
                                                      cut.topology.triangle2shell.end());
    cut.subdomain.vertices.insert(cut.subdomain.vertices.end(), shell.vertices.begin(),
                                  shell.vertices.end());
    for (const auto& [a, b, c] : shell.triangles) {
      cut.subdomain.triangles.push_back({first + a, first + b, first + c});
      cut.colours.push_back(side);
      cut.topology.triangle2shell.push_back(number);
    }
  };
  SurfaceMesh cavity = shapes::box({10.2, 0.2, 0.2}, {10.8, 0.8, 0.8}, 1);
  for (Triangle& t : cavity.triangles) std::swap(t[1], t[2]);
  add(shapes::box({10, 0, 0}, {11, 1, 1}, 1), Side::right);
  add(cavity, Side::right);
  const auto is_right = [&cut] {
    return shells_are_on_their_sides(cut.mesh, cut.subdomain, cut.colours,
                                     cut.topology.triangle2shell);
  };
  EXPECT_TRUE(is_right());
  cut.colours.back() = Side::left;
  const std::size_t first_of_cavity = cut.colours.size() - cavity.triangles.size();
  for (std::size_t t = first_of_cavity; t < cut.colours.size(); ++t) cut.colours[t] = Side::left;
  EXPECT_FALSE(is_right());
}

TEST(CutCheck, angles_at_the_rim_of_a_straight_cut_of_a_box_are_right) {
  const FlatCut cut(shapes::box({0, 0, 0}, {1, 1, 1}, 4), make_cut_plane({0, 0, 1}, 0.5), 0.25);
  const std::vector<double> cosines = cosines_at_rim(cut.mesh, cut.subdomain, cut.corners);
  ASSERT_EQ(cosines.size(), cut.mesh.rim.size());
  for (const double cosine : cosines) EXPECT_NEAR(cosine, 0, 1e-12);
}

TEST(CutCheck, the_smallest_angle_of_the_cut_is_that_of_its_triangles_in_space) {
  InterdomainMesh cut = one_triangle();
  EXPECT_NEAR(cosine_of_smallest_triangle_angle(cut, {}), std::sqrt(0.5), 1e-15);
  // Sides of 1, sqrt(4) and sqrt(5): the smallest angle lies opposite the first.
  cut.heights = {0, 0, std::sqrt(3)};
  EXPECT_NEAR(cosine_of_smallest_triangle_angle(cut, {}), 2 / std::sqrt(5), 1e-15);
}

TEST(CutCheck, takes_less_clearance_at_the_rim_than_elsewhere) {
  SurfaceContact contact;
  contact.distance = 0.29;
  EXPECT_TRUE(is_too_near(contact));
  EXPECT_EQ(judge_contacts({contact}), "clearance");
  contact.is_at_rim = true;
  EXPECT_FALSE(is_too_near(contact));
  EXPECT_EQ(judge_contacts({contact}), "");
  contact.distance = 0.09;
  EXPECT_TRUE(is_too_near(contact));
  SurfaceContact meeting;
  meeting.meets = true;
  EXPECT_EQ(judge_contacts({contact, meeting}), "intersection");
  EXPECT_EQ(judge_contacts({}), "");
}

}  // namespace
}  // namespace tetfarm
