/// A graph with whole-number weights in compressed rows, as METIS and what mends its answers take
/// it.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace tetfarm {

/// The neighbours of node v are neighbour[first[v]] ... neighbour[first[v + 1] - 1].
/// Invariants: an edge is there from both sides with one weight, no node is its own neighbour.
struct WeightedGraph {
  std::vector<std::int32_t> first = {0};
  std::vector<std::int32_t> neighbour;
  std::vector<std::int32_t> edge_weight;  ///< beside `neighbour`
  std::vector<std::int32_t> weight;       ///< of each node

  std::size_t size() const { return weight.size(); }
  std::size_t begin(std::size_t v) const { return static_cast<std::size_t>(first[v]); }
  std::size_t end(std::size_t v) const { return static_cast<std::size_t>(first[v + 1]); }
};

/// Makes the rows of a graph whose nodes have their weights. `for_each_edge` calls what it is given
/// with both nodes of each edge and its weight; it is called twice, and has to say the same.
template <class ForEachEdge>
void make_rows(WeightedGraph& graph, const ForEachEdge& for_each_edge) {
  graph.first.assign(graph.size() + 1, 0);
  for_each_edge([&](std::size_t a, std::size_t b, std::int32_t) {
    ++graph.first[a + 1];
    ++graph.first[b + 1];
  });
  for (std::size_t v = 0; v < graph.size(); ++v) graph.first[v + 1] += graph.first[v];
  graph.neighbour.resize(static_cast<std::size_t>(graph.first.back()));
  graph.edge_weight.resize(graph.neighbour.size());
  std::vector<std::int32_t> next(graph.first.begin(), graph.first.end() - 1);
  for_each_edge([&](std::size_t a, std::size_t b, std::int32_t weight) {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
      const auto place = static_cast<std::size_t>(next[from]++);
      graph.neighbour[place] = static_cast<std::int32_t>(to);
      graph.edge_weight[place] = weight;
    }
  });
}

/// The piece of each node, from 0 in the order of their first nodes: nodes of a piece are of the
/// same part and hang together. Cost: O(nodes + edges).
std::vector<std::int32_t> pieces_of_parts(const WeightedGraph& graph,
                                          const std::vector<std::int32_t>& part_of_node);

/// The graph itself if it is in one piece, else with an edge of weight 1 from the last node of each
/// piece to the first of the next one: so that parts can be whole and even. Cost: O(nodes + edges).
WeightedGraph tie_pieces(WeightedGraph graph);

/// The sum of the weights of all edges between two parts.
std::int64_t edge_cut(const WeightedGraph& graph, const std::vector<std::int32_t>& part_of_node);

std::vector<std::int64_t> weights_of_parts(const WeightedGraph& graph,
                                           const std::vector<std::int32_t>& part_of_node,
                                           std::int32_t parts);

}  // namespace tetfarm
