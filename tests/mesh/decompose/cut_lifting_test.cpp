#include "mesh/decompose/cut_lifting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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

/// Two flat cones of needles, base to base.
SurfaceMesh cones_of_needles(std::int32_t needles) {
  SurfaceMesh surface;
  surface.vertices = {{0, 0, -0.05}, {0, 0, 0.02}};
  for (std::int32_t i = 0; i < needles; ++i) {
    const double turn = 2 * std::numbers::pi * i / needles;
    surface.vertices.push_back({std::cos(turn), std::sin(turn), 0});
    const std::int32_t here = 2 + i;
    const std::int32_t next = 2 + (i + 1) % needles;
    surface.triangles.push_back({0, next, here});
    surface.triangles.push_back({1, here, next});
  }
  surface.patch_of_triangle.assign(surface.triangles.size(), 0);
  surface.patch_names = {"needles"};
  return surface;
}

TEST(CutLifting, gives_up_a_cut_that_is_near_to_many_needles_before_it_is_pushed) {
  for (const std::int32_t needles : {50, 600}) {
    const Subdomain cones = root_subdomain(cones_of_needles(needles));
    const SurfaceTopology topology = make_surface_topology(cones);
    InterdomainMesh cut = one_triangle();
    for (Vec2& p : cut.planar.points) p = {0.1 * p.x, 0.1 * p.y};
    const std::vector<SurfaceContact> contacts =
        lift_and_push(cut, cones, topology, FaceColours(cones.triangles.size(), Side::left), {});
    const bool is_pushed =
        std::any_of(cut.heights.begin(), cut.heights.end(), [](double h) { return h != 0; });
    EXPECT_EQ(is_entangled(cut, contacts), needles == 600);
    EXPECT_EQ(is_pushed, needles == 50);
  }
}

}  // namespace
}  // namespace tetfarm
