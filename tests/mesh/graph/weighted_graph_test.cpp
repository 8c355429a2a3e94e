#include "mesh/graph/weighted_graph.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using testing::Each;
using testing::ElementsAre;

TEST(TiePieces, joins_pieces_by_an_edge_each_and_nothing_else) {
  // Nodes 0 and 2, 1 and 4, and 3 alone.
  WeightedGraph graph;
  graph.first = {0, 1, 2, 3, 3, 4};
  graph.neighbour = {2, 4, 0, 1};
  graph.edge_weight = {5, 6, 5, 6};
  graph.weight = {1, 2, 3, 4, 5};
  const WeightedGraph tied = tie_pieces(graph);
  EXPECT_EQ(tied.weight, graph.weight);
  EXPECT_THAT(tied.first, ElementsAre(0, 1, 3, 5, 6, 8));
  EXPECT_THAT(tied.neighbour, ElementsAre(2, 4, 2, 0, 1, 4, 1, 3));
  EXPECT_THAT(tied.edge_weight, ElementsAre(5, 6, 1, 5, 1, 1, 6, 1));
  EXPECT_THAT(pieces_of_parts(tied, {0, 0, 0, 0, 0}), Each(0));
}

TEST(TiePieces, leaves_a_graph_of_one_piece_as_it_is) {
  WeightedGraph graph;
  graph.first = {0, 1, 2};
  graph.neighbour = {1, 0};
  graph.edge_weight = {3, 3};
  graph.weight = {1, 1};
  const WeightedGraph tied = tie_pieces(graph);
  EXPECT_EQ(tied.neighbour, graph.neighbour);
  EXPECT_EQ(tied.edge_weight, graph.edge_weight);
}

}  // namespace
}  // namespace tetfarm
