#include "mesh/adaptation/naca_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tetfarm {
namespace {

/// Nodes at odd places of the profile from a share of its length to another, and its ends.
std::vector<Vec2> nodes_on(const NacaPlace& place, int n, double from = 0, double to = 1) {
  const NacaProfile profile(place);
  std::vector<Vec2> nodes;
  for (int i = 0; i <= n; ++i) {
    const double share = from + (to - from) * (i + (i % 3 == 1 ? 0.3 : 0)) / n;
    nodes.push_back(profile.at(profile.length() * std::min(share, 1.0)));
  }
  return nodes;
}

void expect_found(const NacaPlace& wanted, const std::vector<Vec2>& nodes, double within) {
  const auto found = fitted_naca(nodes, wanted.thickness);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->is_sharp, wanted.is_sharp);
  EXPECT_NEAR(found->chord, wanted.chord, within);
  EXPECT_NEAR(found->nose.x, wanted.nose.x, within);
  EXPECT_NEAR(found->nose.y, wanted.nose.y, within);
  EXPECT_NEAR(found->along.x, wanted.along.x, within);
  EXPECT_NEAR(found->along.y, wanted.along.y, within);
}

TEST(NacaFit, finds_place_and_trailing_edge_wherever_the_profile_lies) {
  for (const bool is_sharp : {true, false}) {
    for (const double angle : {-4.321, 180.0}) {
      expect_found(
          {0.12, is_sharp, {3.14159, -2.5}, 0.731, direction_of_angle(angle)},
          nodes_on({0.12, is_sharp, {3.14159, -2.5}, 0.731, direction_of_angle(angle)}, 24), 1e-12);
    }
  }
}

TEST(NacaFit, finds_a_profile_by_one_of_its_sides) {
  const NacaPlace place{0.15, true, {0, 0}, 1, {1, 0}};
  expect_found(place, nodes_on(place, 40, 0.5, 1), 1e-12);
}

TEST(NacaFit, has_round_numbers_where_nodes_leave_them_open) {
  const NacaPlace place;
  std::vector<Vec2> nodes = nodes_on(place, 60);
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i].y += i % 2 == 0 ? 1e-8 : -1e-8;
  expect_found(place, nodes, 0);
}

TEST(NacaFit, takes_the_trailing_edge_that_fits_where_the_rest_is_given) {
  for (const bool is_sharp : {true, false}) {
    NacaPlace place;
    place.is_sharp = is_sharp;
    const std::vector<Vec2> nodes = nodes_on(place, 40);
    place.is_sharp = !is_sharp;
    EXPECT_EQ(with_fitting_edge(nodes, place).is_sharp, is_sharp);
  }
}

TEST(NacaFit, wants_five_nodes) {
  EXPECT_FALSE(fitted_naca(std::vector<Vec2>{{0, 0}, {1, 0}, {0.5, 0.1}, {0.2, 0}}, 0.12));
  EXPECT_FALSE(fitted_naca(std::vector<Vec2>(7, {1, 1}), 0.12));
}

}  // namespace
}  // namespace tetfarm
