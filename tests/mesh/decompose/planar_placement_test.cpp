#include "mesh/decompose/planar_placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

std::vector<PlaneCandidate> place(const SurfaceMesh& surface, double h,
                                  const PlacementOptions& options = {}) {
  const Subdomain subdomain = root_subdomain(surface);
  const SpacingField spacing(h);
  return place_planes(subdomain, make_surface_topology(subdomain), sample_work(subdomain, spacing),
                      spacing, options);
}

TEST(PlanarPlacement, halves_a_bar_across_its_longest_axis) {
  const auto candidates = place(shapes::box({0, 0, 0}, {1, 4, 1}, 8), 0.1);
  ASSERT_FALSE(candidates.empty());
  EXPECT_EQ(candidates.front().plane.normal, (Vec3{0, 1, 0}));
  EXPECT_NEAR(candidates.front().plane.offset, 2, 0.1);
}

TEST(PlanarPlacement, leaves_the_wanted_share_below) {
  PlacementOptions options;
  options.left_share = 0.25;
  const auto candidates = place(shapes::box({0, 0, 0}, {4, 1, 1}, 8), 0.1, options);
  EXPECT_NEAR(candidates.front().plane.offset, 1, 0.1);
  EXPECT_EQ(candidates.front().left_share, 0.25);
}

TEST(PlanarPlacement, offers_no_more_than_asked_in_order_of_penalty) {
  PlacementOptions options;
  options.most = 20;
  const auto candidates = place(shapes::torus(0.3, 24, 10), 0.1, options);
  EXPECT_LE(candidates.size(), 20U);
  EXPECT_GE(candidates.size(), 15U);
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    EXPECT_LE(candidates[i - 1].penalty, candidates[i].penalty);
  }
}

TEST(PlanarPlacement, weighs_imbalance_by_the_smaller_side) {
  PlacementOptions options;
  options.planes = CutPlanes::axis;
  options.left_share = 0.2;
  // Across the bar all planes are as large, so that only their shares differ.
  std::vector<double> rest;
  for (const PlaneCandidate& c : place(shapes::box({0, 0, 0}, {8, 1, 1}, 16), 0.1, options)) {
    if (c.plane.normal.x != 1) continue;
    rest.push_back(c.penalty - 3 * std::fabs(c.left_share - 0.2) / 0.2);
  }
  ASSERT_GT(rest.size(), 2U);
  EXPECT_NEAR(*std::ranges::min_element(rest), *std::ranges::max_element(rest), 0.15);
}

TEST(PlanarPlacement, keeps_every_plane_inside) {
  for (const PlaneCandidate& c : place(shapes::sphere({5, 5, 5}, 1, 2), 0.2)) {
    EXPECT_LT(std::fabs(c.plane.height({5, 5, 5})), 0.6);
  }
}

TEST(PlanarPlacement, offers_only_planes_of_the_kind_that_is_asked_for) {
  PlacementOptions options;
  const SurfaceMesh surface = shapes::torus(0.3, 48, 20);
  const auto has_axis_normal = [](const Vec3& n) {
    return std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)}) == 1;
  };
  options.planes = CutPlanes::axis;
  for (const PlaneCandidate& c : place(surface, 0.08, options)) {
    EXPECT_TRUE(has_axis_normal(c.plane.normal) && !c.lattice);
  }
  options.planes = CutPlanes::inertia;
  for (const PlaneCandidate& c : place(surface, 0.08, options)) {
    EXPECT_FALSE(c.lattice.has_value());
  }
  options.planes = CutPlanes::lattice;
  const auto of_lattice = place(surface, 0.08, options);
  EXPECT_GE(of_lattice.size(), 6U);
  for (const PlaneCandidate& c : of_lattice) EXPECT_TRUE(c.lattice.has_value());
}

}  // namespace
}  // namespace tetfarm
