#include "mesh/decompose/intersection_repair.h"

#include <gtest/gtest.h>

#include "tests/mesh/decompose/flat_cut.h"

namespace tetfarm {
namespace {

/// Surface that covers the cut, level, at a height.
Subdomain surface_at(double height) {
  Subdomain surface;
  surface.vertices = {{-9, -9, height}, {9, -9, height}, {0, 18, height}};
  surface.triangles = {{0, 1, 2}};
  return surface;
}

struct Push {
  int contacts = 0;
  std::vector<std::optional<double>> heights;
};

Push pushed_off(double height, Side side, const PushOptions& options = {}) {
  SurfaceContact contact;
  contact.meets = true;
  contact.unit = 1;
  Push push;
  push.contacts =
      push_nodes(one_triangle(), surface_at(height), {side}, {contact}, push.heights, options);
  return push;
}

TEST(IntersectionRepair, takes_nodes_clear_of_the_surface_on_the_side_of_its_colour) {
  // What is left of the cut lies below it.
  const Push up = pushed_off(0.1, Side::left);
  const Push down = pushed_off(0.1, Side::right);
  EXPECT_EQ(up.contacts, 1);
  EXPECT_EQ(down.contacts, 1);
  for (std::size_t v = 0; v < 3; ++v) {
    EXPECT_NEAR(up.heights.at(v).value(), 0.1 + PushOptions{}.to, 1e-12);
    EXPECT_NEAR(down.heights.at(v).value(), 0.1 - PushOptions{}.to, 1e-12);
  }
}

TEST(IntersectionRepair, moves_no_node_farther_at_once_than_allowed) {
  PushOptions options;
  options.to = 10;  // so that the surface is felt from afar
  options.farthest = 11.5;
  EXPECT_EQ(pushed_off(1, Side::left, options).contacts, 1);
  options.farthest = 10.5;
  EXPECT_EQ(pushed_off(1, Side::left, options).contacts, 0);
}

TEST(IntersectionRepair, leaves_alone_what_is_clear_already) {
  EXPECT_EQ(pushed_off(-0.7, Side::left).contacts, 0);
  EXPECT_EQ(pushed_off(0.7, Side::right).contacts, 0);
}

TEST(IntersectionRepair, pushes_the_cut_off_a_plate_that_it_nearly_touches) {
  FlatCut cut = cut_at_plate(0.51, 0.6);
  std::vector<std::optional<double>> pushed;
  const auto nearby = find_nearby_surface(cut.mesh, cut.subdomain, cut.topology, 2);
  for (int i = 0; i < 4; ++i) {
    lift_heights(cut.mesh, cut.corners, cut.weights(), pushed);
    const auto contacts = find_contacts(cut.mesh, cut.subdomain, cut.topology, nearby, 0.4);
    if (i == 0) {
      EXPECT_EQ(judge_contacts(contacts), "clearance");
    }
    if (push_nodes(cut.mesh, cut.subdomain, cut.colours, contacts, pushed) == 0) break;
  }
  const auto contacts = find_contacts(cut.mesh, cut.subdomain, cut.topology, nearby, 0.4);
  EXPECT_EQ(judge_contacts(contacts), "");
  EXPECT_TRUE(
      shells_are_on_their_sides(cut.mesh, cut.subdomain, cut.colours, cut.topology.triangle2shell));
}

}  // namespace
}  // namespace tetfarm
