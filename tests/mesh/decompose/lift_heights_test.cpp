#include "mesh/decompose/lift_heights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/array_index.h"
#include "tests/mesh/decompose/flat_cut.h"

namespace tetfarm {
namespace {

TEST(LiftHeights, meets_a_sphere_at_better_angles_than_the_plane) {
  FlatCut cut = cap_of_sphere();
  const double flat = cut.worst_cosine();
  lift_heights(cut.mesh, cut.corners, cut.weights(), {});
  EXPECT_GT(flat, cosine_of_degrees(45));
  EXPECT_LT(cut.worst_cosine(), cosine_of_degrees(50));
}

TEST(LiftHeights, leaves_a_flat_cut_of_a_box_flat) {
  FlatCut cut(shapes::box({0, 0, 0}, {1, 1, 1}, 4), make_cut_plane({1, 0, 0}, 0.5), 0.25);
  lift_heights(cut.mesh, cut.corners, cut.weights(), {});
  for (const double height : cut.mesh.heights) EXPECT_NEAR(height, 0, 1e-12);
}

TEST(LiftHeights, puts_pushed_nodes_where_they_are_pushed) {
  FlatCut cut = cap_of_sphere();
  std::vector<std::optional<double>> pushed(cut.mesh.heights.size());
  pushed.back() = 0.05;
  lift_heights(cut.mesh, cut.corners, cut.weights(), pushed);
  EXPECT_EQ(cut.mesh.heights.back(), 0.05);
}

/// The largest height of a new node, in largest heights of rim nodes.
double rise_of(double steepest_slope) {
  FlatCut cut = cap_of_sphere();
  LiftOptions options;
  options.steepest_slope = steepest_slope;
  lift_heights(cut.mesh, cut.corners, cut.weights(), {}, options);
  double rim = 0;
  double inside = 0;
  for (std::size_t v = 0; v < cut.mesh.heights.size(); ++v) {
    double& largest = v < cut.mesh.rim_vertices.size() ? rim : inside;
    largest = std::max(largest, std::fabs(cut.mesh.heights[v]));
  }
  return inside / rim;
}

TEST(LiftHeights, are_no_steeper_at_the_rim_than_allowed) {
  EXPECT_GT(rise_of(2), 1.4) << "beyond the rim, where the bisectors lead";
  EXPECT_LT(rise_of(1), 0.9 * rise_of(2));
  EXPECT_LT(rise_of(0.5), 0.9 * rise_of(1));
  EXPECT_LT(rise_of(0), 1) << "level from the rim inward";
}

}  // namespace
}  // namespace tetfarm
