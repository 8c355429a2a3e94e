#include "mesh/assimilation/subdomain_graph.h"

#include <gmock/gmock.h>

#include "base/error.h"

namespace tetfarm {
namespace {

/// A leaf that has these triangles of the cut of the root, besides some of the input surface.
Subdomain leaf_with(std::uint64_t heap, const std::vector<std::uint32_t>& triangles_of_cut) {
  Subdomain leaf;
  leaf.path = {heap};
  const auto add = [&leaf](const Origin& origin) {
    const auto first = static_cast<std::int32_t>(leaf.vertices.size());
    for (std::int32_t i = 0; i < 3; ++i) {
      leaf.vertices.emplace_back();
      leaf.node_origin.push_back({origin.owner, static_cast<std::uint32_t>(first + i)});
    }
    leaf.triangles.push_back({first, first + 1, first + 2});
    leaf.triangle_origin.push_back(origin);
  };
  add({0, 3});
  for (const std::uint32_t triangle : triangles_of_cut) add({1, triangle});
  return leaf;
}

SubdomainGraph graph_of(const std::vector<Subdomain>& leaves) {
  SubdomainGraphBuilder builder;
  for (const Subdomain& leaf : leaves) builder.add(leaf, 5);
  return std::move(builder).finish();
}

TEST(SubdomainGraph, joins_leaves_by_the_triangles_that_they_share) {
  // The root's cut, whose left side is one leaf and whose right side is two.
  const SubdomainGraph graph =
      graph_of({leaf_with(6, {4, 1}), leaf_with(7, {0}), leaf_with(2, {0, 1, 4})});
  ASSERT_EQ(graph.size(), 3U);
  ASSERT_EQ(graph.neighbours[2].size(), 2U);
  EXPECT_EQ(graph.neighbours[2][0].leaf, 0);
  EXPECT_EQ(graph.neighbours[2][0].triangles, 2);
  EXPECT_EQ(graph.neighbours[2][1].leaf, 1);
  EXPECT_EQ(graph.neighbours[2][1].triangles, 1);
  ASSERT_EQ(graph.neighbours[0].size(), 1U);
  EXPECT_EQ(graph.neighbours[0][0].leaf, 2);
  EXPECT_EQ(graph.faces[2], 4);
}

TEST(SubdomainGraph, refuses_a_triangle_of_a_cut_that_one_leaf_has_twice) {
  EXPECT_THROW(graph_of({leaf_with(2, {0, 0}), leaf_with(3, {1})}), Error);
  EXPECT_THROW(graph_of({leaf_with(2, {5, 5})}), Error);
}

TEST(SubdomainGraph, refuses_a_triangle_of_a_cut_that_one_leaf_or_three_have) {
  EXPECT_THROW(graph_of({leaf_with(2, {0}), leaf_with(3, {0, 1})}), Error);
  EXPECT_THROW(graph_of({leaf_with(2, {0}), leaf_with(6, {0}), leaf_with(7, {0})}), Error);
}

}  // namespace
}  // namespace tetfarm
