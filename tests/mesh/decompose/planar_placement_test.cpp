#include "mesh/decompose/planar_placement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

std::vector<PlaneCandidate> place(const SurfaceMesh& surface, double h, double share, int most) {
  const Subdomain subdomain = root_subdomain(surface);
  return place_planes(subdomain, make_surface_topology(subdomain),
                      sample_work(subdomain, SpacingField(h)), share, most);
}

TEST(PlanarPlacement, halves_a_bar_across_its_longest_axis) {
  const auto candidates = place(shapes::box({0, 0, 0}, {1, 4, 1}, 8), 0.1, 0.5, 36);
  ASSERT_FALSE(candidates.empty());
  EXPECT_EQ(candidates.front().plane.normal, (Vec3{0, 1, 0}));
  EXPECT_NEAR(candidates.front().plane.offset, 2, 1e-9);
}

TEST(PlanarPlacement, leaves_the_wanted_share_below) {
  const auto candidates = place(shapes::box({0, 0, 0}, {4, 1, 1}, 8), 0.1, 0.25, 36);
  EXPECT_NEAR(candidates.front().plane.offset, 1, 1e-9);
  EXPECT_EQ(candidates.front().left_share, 0.25);
}

TEST(PlanarPlacement, offers_no_more_than_asked_in_order_of_penalty) {
  const auto candidates = place(shapes::torus(0.3, 24, 10), 0.1, 0.5, 20);
  EXPECT_LE(candidates.size(), 20U);
  EXPECT_GE(candidates.size(), 15U);
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    EXPECT_LE(candidates[i - 1].penalty, candidates[i].penalty);
  }
}

TEST(PlanarPlacement, keeps_every_plane_inside) {
  for (const PlaneCandidate& c : place(shapes::sphere({5, 5, 5}, 1, 2), 0.2, 0.5, 36)) {
    EXPECT_LT(std::fabs(c.plane.height({5, 5, 5})), 0.6);
  }
}

}  // namespace
}  // namespace tetfarm
