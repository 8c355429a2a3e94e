// Graphs made coarser, mended and refined, known by their digests (tests/golden/graph.txt).
#include <gtest/gtest.h>

#include "mesh/graph/graph_coarsening.h"
#include "mesh/graph/part_refinement.h"
#include "tests/mesh/graph/graph_grid.h"
#include "tests/support/chance.h"
#include "tests/support/result_digest.h"

namespace tetfarm {
namespace {

using test::ResultDigest;

void add_graph(ResultDigest& result, const WeightedGraph& graph) {
  result.add(graph.first, graph.neighbour, graph.edge_weight, graph.weight);
}

/// A grid whose nodes and edges have weights by their numbers.
WeightedGraph uneven_grid(std::int32_t n) {
  WeightedGraph graph = test::graph_grid(n);
  for (std::size_t v = 0; v < graph.size(); ++v) {
    graph.weight[v] = 1 + static_cast<std::int32_t>(v * 7 % 5);
    for (std::size_t e = graph.begin(v); e < graph.end(v); ++e) {
      const auto other = static_cast<std::size_t>(graph.neighbour[e]);
      graph.edge_weight[e] = 1 + static_cast<std::int32_t>((v + other) * 3 % 4);
    }
  }
  return graph;
}

TEST(GraphResults, of_coarser_graphs_are_known) {
  for (const bool is_even : {true, false}) {
    ResultDigest result;
    const WeightedGraph graph = is_even ? test::graph_grid(12) : uneven_grid(12);
    for (const std::size_t movable : {144UL, 100UL}) {
      for (const GraphLevel& level : coarsen_graph(graph, movable, 10)) {
        add_graph(result, level.graph);
        result.add(level.movable, level.coarse_of);
      }
    }
    test::expect_known("graph", is_even ? "coarse" : "coarse_uneven", result);
  }
}

TEST(GraphResults, of_parts_that_are_mended_are_known) {
  const WeightedGraph graph = uneven_grid(12);
  shapes::Chance chance(11);
  ResultDigest result;
  for (const std::int32_t parts : {2, 5}) {
    // Stripes with some nodes out of place.
    std::vector<std::int32_t> part_of_node(graph.size());
    for (std::size_t v = 0; v < graph.size(); ++v) {
      part_of_node[v] = static_cast<std::int32_t>(v) * parts / 144;
      if (chance.pick(0, 5) == 0) part_of_node[v] = chance.pick(0, parts - 1);
    }
    result.add(pieces_of_parts(graph, part_of_node), edge_cut(graph, part_of_node));
    join_pieces(graph, parts, part_of_node);
    result.add(part_of_node);
    std::vector<std::int64_t> weights = weights_of_parts(graph, part_of_node, parts);
    result.add(weights);
    for (const std::size_t movable : {90UL, 144UL}) {
      PartRefinement options;
      options.heaviest = 450 / parts;
      options.passes = movable == 90 ? 2 : 8;
      refine_parts(graph, movable, options, part_of_node, weights);
      result.add(part_of_node, weights, edge_cut(graph, part_of_node));
    }
  }
  test::expect_known("graph", "parts", result);
}

TEST(GraphResults, of_pieces_that_are_tied_are_known) {
  WeightedGraph apart;
  apart.weight = {1, 2, 3, 4, 5, 6, 7};
  make_rows(apart, [](const auto& edge) {
    edge(0, 3, 2);
    edge(1, 5, 4);
    edge(5, 2, 1);
  });
  ResultDigest result;
  add_graph(result, apart);
  add_graph(result, tie_pieces(apart));
  add_graph(result, tie_pieces(test::graph_grid(3)));
  test::expect_known("graph", "tied", result);
}

}  // namespace
}  // namespace tetfarm
