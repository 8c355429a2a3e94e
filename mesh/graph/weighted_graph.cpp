#include "mesh/graph/weighted_graph.h"

#include "base/check.h"

namespace tetfarm {

std::vector<std::int32_t> pieces_of_parts(const WeightedGraph& graph,
                                          const std::vector<std::int32_t>& part_of_node) {
  TF_CHECK(part_of_node.size() == graph.size());
  std::vector<std::int32_t> piece_of_node(graph.size(), -1);
  std::int32_t pieces = 0;
  std::vector<std::size_t> open;
  for (std::size_t start = 0; start < graph.size(); ++start) {
    if (piece_of_node[start] >= 0) continue;
    piece_of_node[start] = pieces;
    open.push_back(start);
    while (!open.empty()) {
      const std::size_t v = open.back();
      open.pop_back();
      for (std::size_t e = graph.begin(v); e < graph.end(v); ++e) {
        const auto w = static_cast<std::size_t>(graph.neighbour[e]);
        if (piece_of_node[w] >= 0 || part_of_node[w] != part_of_node[v]) continue;
        piece_of_node[w] = pieces;
        open.push_back(w);
      }
    }
    ++pieces;
  }
  return piece_of_node;
}

WeightedGraph tie_pieces(WeightedGraph graph) {
  const std::vector<std::int32_t> piece_of_node =
      pieces_of_parts(graph, std::vector<std::int32_t>(graph.size(), 0));
  std::vector<std::int32_t> first_node;
  std::vector<std::int32_t> last_node;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    const auto piece = static_cast<std::size_t>(piece_of_node[v]);
    if (piece == first_node.size()) {
      first_node.push_back(static_cast<std::int32_t>(v));
      last_node.push_back(0);
    }
    last_node[piece] = static_cast<std::int32_t>(v);
  }
  if (first_node.size() < 2) return graph;
  WeightedGraph tied;
  tied.weight = std::move(graph.weight);
  const auto add = [&tied](std::int32_t neighbour, std::int32_t edge_weight) {
    tied.neighbour.push_back(neighbour);
    tied.edge_weight.push_back(edge_weight);
  };
  for (std::size_t v = 0; v < tied.size(); ++v) {
    for (std::size_t e = graph.begin(v); e < graph.end(v); ++e) {
      add(graph.neighbour[e], graph.edge_weight[e]);
    }
    const auto piece = static_cast<std::size_t>(piece_of_node[v]);
    const auto node = static_cast<std::int32_t>(v);
    if (piece > 0 && node == first_node[piece]) add(last_node[piece - 1], 1);
    if (piece + 1 < first_node.size() && node == last_node[piece]) add(first_node[piece + 1], 1);
    tied.first.push_back(static_cast<std::int32_t>(tied.neighbour.size()));
  }
  TF_CHECK(tied.neighbour.size() == graph.neighbour.size() + 2 * (first_node.size() - 1));
  return tied;
}

std::int64_t edge_cut(const WeightedGraph& graph, const std::vector<std::int32_t>& part_of_node) {
  std::int64_t cut = 0;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    for (std::size_t e = graph.begin(v); e < graph.end(v); ++e) {
      const auto w = static_cast<std::size_t>(graph.neighbour[e]);
      if (w > v && part_of_node[w] != part_of_node[v]) cut += graph.edge_weight[e];
    }
  }
  return cut;
}

std::vector<std::int64_t> weights_of_parts(const WeightedGraph& graph,
                                           const std::vector<std::int32_t>& part_of_node,
                                           std::int32_t parts) {
  TF_CHECK(part_of_node.size() == graph.size());
  std::vector<std::int64_t> weights(static_cast<std::size_t>(parts));
  for (std::size_t v = 0; v < graph.size(); ++v) {
    weights.at(static_cast<std::size_t>(part_of_node[v])) += graph.weight[v];
  }
  return weights;
}

}  // namespace tetfarm
