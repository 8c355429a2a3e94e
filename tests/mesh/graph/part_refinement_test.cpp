#include "mesh/graph/part_refinement.h"

#include <gmock/gmock.h>

#include "tests/mesh/graph/graph_grid.h"

namespace tetfarm {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

std::int32_t pieces_in(const WeightedGraph& graph, const std::vector<std::int32_t>& parts) {
  const std::vector<std::int32_t> pieces = pieces_of_parts(graph, parts);
  return *std::max_element(pieces.begin(), pieces.end()) + 1;
}

/// Left and right halves, with a ragged border.
std::vector<std::int32_t> ragged_halves(std::int32_t n) {
  std::vector<std::int32_t> parts;
  for (std::int32_t y = 0; y < n; ++y) {
    for (std::int32_t x = 0; x < n; ++x) parts.push_back(2 * x < n + (y % 2 == 0 ? 3 : -3) ? 0 : 1);
  }
  return parts;
}

TEST(PartRefinement, a_ragged_border_becomes_shorter_and_parts_stay_even_and_whole) {
  const WeightedGraph graph = test::graph_grid(20);
  std::vector<std::int32_t> parts = ragged_halves(20);
  std::vector<std::int64_t> weights = weights_of_parts(graph, parts, 2);
  const std::int64_t before = edge_cut(graph, parts);
  refine_parts(graph, graph.size(), {206, 8}, parts, weights);
  EXPECT_LT(2 * edge_cut(graph, parts), before);
  EXPECT_EQ(weights, weights_of_parts(graph, parts, 2));
  EXPECT_THAT(weights, Each(testing::Le(206)));
  EXPECT_EQ(pieces_in(graph, parts), 2);
}

TEST(PartRefinement, a_part_that_is_too_heavy_gives_away_though_the_cut_grows) {
  const WeightedGraph graph = test::graph_grid(20);
  std::vector<std::int32_t> parts(400, 0);
  for (std::size_t v = 0; v < 10; ++v) parts[v] = 1;
  std::vector<std::int64_t> weights = weights_of_parts(graph, parts, 2);
  refine_parts(graph, graph.size(), {206, 60}, parts, weights);
  EXPECT_THAT(weights, Each(testing::Le(206)));
  EXPECT_EQ(pieces_in(graph, parts), 2);
}

TEST(PartRefinement, nodes_that_are_only_seen_stay) {
  const WeightedGraph graph = test::graph_grid(20);
  std::vector<std::int32_t> parts = ragged_halves(20);
  const std::vector<std::int32_t> before = parts;
  std::vector<std::int64_t> weights = weights_of_parts(graph, parts, 2);
  refine_parts(graph, 200, {206, 8}, parts, weights);
  EXPECT_TRUE(std::equal(before.begin() + 200, before.end(), parts.begin() + 200));
  EXPECT_FALSE(std::equal(before.begin(), before.begin() + 200, parts.begin()));
}

TEST(PartRefinement, a_node_that_holds_its_part_together_stays) {
  // Two blocks of part 0 are joined by one node, on either side of which is the lighter part 1.
  const WeightedGraph graph = test::graph_grid(7);
  std::vector<std::int32_t> parts(49, 0);
  for (std::size_t x = 0; x < 7; ++x) parts[21 + x] = x == 3 ? 0 : 1;
  std::vector<std::int64_t> weights = weights_of_parts(graph, parts, 2);
  refine_parts(graph, 25, {43, 1}, parts, weights);
  const std::vector<std::int32_t> pieces = pieces_of_parts(graph, parts);
  for (std::size_t v = 0; v < 49; ++v) {
    EXPECT_TRUE(parts[v] != 0 || pieces[v] == pieces[0]) << v;
  }
}

TEST(JoinPieces, smaller_pieces_go_to_the_part_with_most_edges_to_them) {
  const WeightedGraph graph = test::graph_grid(4);
  // The upper half is part 0 but for two nodes of part 1 in its corner, and one of 2 beside them.
  std::vector<std::int32_t> parts = {1, 1, 2, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2};
  join_pieces(graph, 3, parts);
  EXPECT_THAT(parts, ElementsAre(0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2));
}

TEST(JoinPieces, pieces_that_touch_nothing_stay) {
  WeightedGraph graph;
  graph.first = {0, 0, 0, 0};
  graph.weight = {1, 1, 1};
  std::vector<std::int32_t> parts = {0, 1, 0};
  join_pieces(graph, 2, parts);
  EXPECT_THAT(parts, ElementsAre(0, 1, 0));
}

}  // namespace
}  // namespace tetfarm
