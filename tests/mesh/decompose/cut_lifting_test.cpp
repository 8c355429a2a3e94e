#include "mesh/decompose/cut_lifting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/mesh/decompose/flat_cut.h"

namespace tetfarm {
namespace {

std::vector<SurfaceContact> lift_and_push(FlatCut& cut) {
  return lift_and_push(cut.mesh, cut.subdomain, cut.topology, cut.colours, cut.corners);
}

std::vector<SurfaceContact> contacts_of(const FlatCut& cut) {
  return find_contacts(cut.mesh, cut.subdomain, cut.topology,
                       find_nearby_surface(cut.mesh, cut.subdomain, cut.topology, 2), 0.4);
}

void expect_same(const std::vector<SurfaceContact>& a, const std::vector<SurfaceContact>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].cut_triangle, b[i].cut_triangle);
    EXPECT_EQ(a[i].surface_triangle, b[i].surface_triangle);
    EXPECT_EQ(a[i].distance, b[i].distance);
  }
}

TEST(CutLifting, meets_a_sphere_at_better_angles_than_one_lift_alone) {
  FlatCut once = cap_of_sphere();
  lift_heights(once.mesh, once.corners, once.weights(), {});
  FlatCut cut = cap_of_sphere();
  const auto contacts = lift_and_push(cut);
  EXPECT_LE(cut.worst_cosine(), once.worst_cosine());
  EXPECT_LE(cut.worst_cosine(), cosine_of_degrees(45));
  expect_same(contacts, contacts_of(cut));
}

TEST(CutLifting, pushes_a_cut_off_a_plate_that_lies_close_above_it) {
  FlatCut cut = cut_at_plate(0.505, 0.56);
  EXPECT_EQ(judge_contacts(contacts_of(cut)), "clearance");
  const auto contacts = lift_and_push(cut);
  EXPECT_EQ(judge_contacts(contacts), "");
  expect_same(contacts, contacts_of(cut));
  const double lowest = *std::min_element(cut.mesh.heights.begin(), cut.mesh.heights.end());
  EXPECT_LT(lowest, -0.02) << "the plate is of the right side, above";
}

TEST(CutLifting, pushes_a_cut_out_of_a_plate_that_it_runs_through) {
  FlatCut cut = cut_at_plate(0.49, 0.53);
  EXPECT_EQ(judge_contacts(contacts_of(cut)), "intersection");
  EXPECT_EQ(judge_contacts(lift_and_push(cut)), "");
}

TEST(CutLifting, leaves_nodes_of_the_lattice_that_are_held_in_the_plane) {
  FlatCut cut = cap_of_sphere();
  // The last new node, as if it were one of the lattice: those of the lattice come first.
  const std::size_t first = cut.mesh.rim_vertices.size();
  for (std::size_t i = first; i < cut.mesh.planar.points.size(); ++i) {
    const bool is_held = i % 2 == 0;
    cut.mesh.lattice.push_back({cut.mesh.plane.lift(cut.mesh.planar.points[i], 0), is_held});
  }
  lift_and_push(cut);
  double highest = 0;
  for (std::size_t i = first; i < cut.mesh.planar.points.size(); ++i) {
    const LatticeNodeOfCut& node = cut.mesh.lattice[i - first];
    if (node.is_held) {
      EXPECT_EQ(cut.mesh.heights[i], cut.mesh.plane.height(node.at));
    } else {
      highest = std::max(highest, std::fabs(cut.mesh.heights[i]));
    }
  }
  EXPECT_GT(highest, 0.01) << "the others are lifted";
}

TEST(CutLifting, of_a_cut_without_a_rim_changes_nothing) {
  // A cut between pieces that are apart has no triangles.
  FlatCut cut(shapes::between(shapes::sphere({0, 0, -3}, 1, 1), shapes::sphere({0, 0, 3}, 1, 1)),
              make_cut_plane({0, 0, 1}, 0), 0.5);
  EXPECT_TRUE(cut.mesh.rim.empty());
  EXPECT_TRUE(lift_and_push(cut).empty());
  EXPECT_TRUE(cut.mesh.heights.empty());
}

}  // namespace
}  // namespace tetfarm
