#include "mesh/decompose/work_estimate.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/decompose/planar_cut.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

constexpr double mean_edge_over_cell = 0.92;
constexpr double tets_per_node = 6;
constexpr double tets_per_triangle = 1.3;
constexpr std::size_t all_of_them = 10'000'000;

/// Lattice nodes in the unit cube that keep 0.5 mean edges from its sides and 0.6 from its nodes:
/// what mesh/volume takes.
double nodes_taken_in_unit_cube(const SurfaceMesh& cube, const SpacingField& spacing) {
  double count = 0;
  for (const LatticeNode& node : spacing.lattice_nodes({{0, 0, 0}, {1, 1, 1}})) {
    const double h = mean_edge_over_cell * node.cell_edge;
    double to_side = 1;
    for (int axis = 0; axis < 3; ++axis) {
      to_side = std::min({to_side, node.at[axis], 1 - node.at[axis]});
    }
    const bool is_clear =
        std::none_of(cube.vertices.begin(), cube.vertices.end(),
                     [&](const Vec3& vertex) { return norm(vertex - node.at) < 0.6 * h; });
    if (to_side >= 0.5 * h && is_clear) ++count;
  }
  return count;
}

TEST(WorkEstimate, counts_the_lattice_nodes_that_the_mesher_takes) {
  const SurfaceMesh cube = shapes::box({0, 0, 0}, {1, 1, 1}, 10);
  for (const double h : {0.063, 0.1, 0.117, 0.3}) {
    const SpacingField spacing(h);
    const double expected = tets_per_node * nodes_taken_in_unit_cube(cube, spacing) +
                            tets_per_triangle * static_cast<double>(cube.triangles.size());
    const WorkSamples work = sample_work(root_subdomain(cube), spacing, all_of_them);
    EXPECT_NEAR(work.total, expected, 1e-9 * expected) << h;
  }
}

TEST(WorkEstimate, of_some_nodes_is_close_to_that_of_all) {
  const SpacingField spacing(0.03);
  for (const SurfaceMesh& surface :
       {shapes::nested_spheres(4), shapes::torus(0.3, 60, 30), shapes::sphere({1, 2, 3}, 0.5, 4)}) {
    const Subdomain root = root_subdomain(surface);
    const double all = sample_work(root, spacing, all_of_them).total;
    EXPECT_NEAR(sample_work(root, spacing).total, all, 0.03 * all);
    EXPECT_NEAR(estimated_elements(root, spacing), all, 0.02 * all);
  }
}

TEST(WorkEstimate, knows_the_boundary_when_there_is_no_room_for_nodes) {
  const SurfaceMesh surface = shapes::sphere({0, 0, 0}, 1, 2);
  EXPECT_NEAR(estimated_elements(root_subdomain(surface), SpacingField(3.0)),
              tets_per_triangle * static_cast<double>(surface.triangles.size()), 1e-9);
}

TEST(WorkEstimate, of_more_nodes_than_could_be_visited_follows_the_volume) {
  const SurfaceMesh ball = shapes::sphere({0, 0, 0}, 0.5, 3);
  for (const double h : {1e-4, 1e-5, 1e-6}) {
    SpacingOptions options;
    options.background = h;
    const SpacingField spacing = make_spacing_field(ball, options);
    const double edge = spacing.lattice_cell_edge({0, 0, 0});
    const double expected = 2 * tets_per_node * domain_volume(ball) / (edge * edge * edge);
    EXPECT_NEAR(estimated_elements(root_subdomain(ball), spacing), expected, 0.02 * expected) << h;
  }
}

TEST(WorkEstimate, keeps_samples_inside) {
  const WorkSamples work =
      sample_work(root_subdomain(shapes::nested_spheres(3)), SpacingField(0.1));
  double total = 0;
  for (const WorkSample& s : work.samples) {
    EXPECT_LT(norm(s.at), 1.0);
    EXPECT_GT(norm(s.at), 0.38);
    total += s.work;
  }
  EXPECT_NEAR(total, work.total, 1e-9 * total);
}

}  // namespace
}  // namespace tetfarm
