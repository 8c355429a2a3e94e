#include "mesh/filling/lattice_cost.h"

#include <gtest/gtest.h>

#include "mesh/volume/volume_mesh.h"
#include "tests/support/thin_domains.h"

namespace tetfarm {
namespace {

/// Of the nodes in the domain and the triangles round it, so many cells may be visited and nodes
/// listed for each.
constexpr double most_cells_for_each = 7;
constexpr double most_listed_for_each = 10;

LatticeCost cost_of(const SurfaceMesh& surface, double size) {
  SpacingOptions spacing;
  spacing.background = size;
  VolumeMeshOptions options;
  options.cosmetics = false;
  VolumeMeshReport report;
  mesh_volume(root_subdomain(surface), make_spacing_field(surface, spacing), options, &report);
  return report.lattice;
}

void expect_cost_in_proportion(const SurfaceMesh& surface, double size) {
  const LatticeCost cost = cost_of(surface, size);
  const auto kept =
      static_cast<double>(cost.inside) + static_cast<double>(surface.triangles.size());
  EXPECT_GT(cost.inside, 0);
  EXPECT_LE(static_cast<double>(cost.visits.cells), most_cells_for_each * kept);
  EXPECT_LE(static_cast<double>(cost.visits.questions), most_cells_for_each * kept);
  EXPECT_LE(static_cast<double>(cost.listed), most_listed_for_each * kept);
}

TEST(LatticeCost, of_a_thin_wing_is_in_proportion_to_what_is_kept) {
  const SurfaceMesh wing = shapes::thin_wing(0.04, 16);
  expect_cost_in_proportion(wing, 0);
  expect_cost_in_proportion(wing, 0.025);
  expect_cost_in_proportion(shapes::in_large_box(wing, 3, 4), 0);
}

TEST(LatticeCost, of_a_spiral_is_in_proportion_to_what_is_kept) {
  const SurfaceMesh spiral = shapes::spiral(2, 8);
  expect_cost_in_proportion(spiral, 0);
  expect_cost_in_proportion(spiral, 0.018);
  expect_cost_in_proportion(shapes::in_large_box(spiral, 3, 4), 0);
}

TEST(LatticeCost, of_a_thin_shell_is_in_proportion_to_what_is_kept) {
  expect_cost_in_proportion(shapes::thin_shell(0.05, 3), 0.03);
  expect_cost_in_proportion(shapes::in_large_box(shapes::thin_shell(0.05, 3), 3, 4), 0);
}

TEST(LatticeCost, of_small_bodies_in_a_large_box_is_in_proportion_to_what_is_kept) {
  expect_cost_in_proportion(shapes::in_large_box(shapes::scattered_bodies(3), 4, 4), 0);
}

}  // namespace
}  // namespace tetfarm
