#include "mesh/layers/prism_division.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

using Edge = std::pair<int, int>;

TEST(PrismDivision, has_three_positive_tets_that_fill_the_prism_whatever_the_order_of_the_feet) {
  const std::array<Vec3, 6> nodes = {
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};
  std::array<std::int32_t, 3> feet = {4, 7, 9};
  do {
    double volume = 0;
    for (const auto& [a, b, c, d] : tets_of_prism(feet)) {
      EXPECT_GT(orient3d(nodes.at(a), nodes.at(b), nodes.at(c), nodes.at(d)), 0);
      volume += tet_volume(nodes.at(a), nodes.at(b), nodes.at(c), nodes.at(d));
    }
    EXPECT_DOUBLE_EQ(volume, 0.5);
  } while (std::next_permutation(feet.begin(), feet.end()));
}

TEST(PrismDivision, draws_each_diagonal_from_the_wall_at_the_lower_foot) {
  std::array<std::int32_t, 3> feet = {4, 7, 9};
  do {
    std::set<Edge> edges;
    for (const auto& tet : tets_of_prism(feet)) {
      for (const std::uint8_t a : tet) {
        for (const std::uint8_t b : tet) edges.emplace(a, b);
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (i == j) continue;
        const Edge diagonal(static_cast<int>(i), static_cast<int>(j + 3));
        EXPECT_EQ(edges.contains(diagonal), feet.at(i) < feet.at(j));
      }
    }
  } while (std::next_permutation(feet.begin(), feet.end()));
}

TEST(PrismDivision, of_a_pyramid_has_two_positive_tets_on_either_side_of_the_diagonal) {
  const std::array<Vec3, 5> nodes = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}}};
  for (std::size_t corner = 0; corner < 4; ++corner) {
    double volume = 0;
    std::multiset<std::uint8_t> corners;
    for (const auto& tet : tets_of_pyramid(corner)) {
      const auto [a, b, c, d] = tet;
      EXPECT_GT(orient3d(nodes.at(a), nodes.at(b), nodes.at(c), nodes.at(d)), 0);
      volume += tet_volume(nodes.at(a), nodes.at(b), nodes.at(c), nodes.at(d));
      corners.insert(tet.begin(), tet.end());
    }
    EXPECT_DOUBLE_EQ(volume, 1.0 / 3);
    EXPECT_EQ(corners.count(static_cast<std::uint8_t>(corner)), 2U) << "the diagonal's ends";
    EXPECT_EQ(corners.count(static_cast<std::uint8_t>((corner + 2) % 4)), 2U);
  }
}

TEST(PrismDivision, orders_lines_by_their_feet_and_those_of_one_foot_by_their_tops) {
  LayerLine line;
  line.foot = 5;
  line.stop = 3;
  LayerLine on_surface = line;
  on_surface.vertices = 1;
  on_surface.first_vertex = 40;
  LayerLine next_on_surface = on_surface;
  next_on_surface.first_vertex = 42;
  LayerLine other_foot = line;
  other_foot.foot = 6;
  EXPECT_LT(order_of(line, 7), order_of(line, 8));
  EXPECT_LT(order_of(line, 8), order_of(other_foot, 1));
  EXPECT_LT(order_of(on_surface, 0), order_of(next_on_surface, 0));
  EXPECT_LT(order_of(next_on_surface, 9), order_of(line, 0));
}

}  // namespace
}  // namespace tetfarm
