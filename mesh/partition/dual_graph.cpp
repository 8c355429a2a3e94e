#include "mesh/partition/dual_graph.h"

namespace tetfarm {

WeightedGraph dual_graph(const CellFaces& cells, std::size_t tets,
                         const std::vector<std::int32_t>& beyond) {
  const auto at = [](std::int32_t i) { return static_cast<std::size_t>(i); };
  const std::size_t nodes = tets + beyond.size();
  WeightedGraph graph;
  graph.weight.assign(nodes, 1);
  const auto for_each_edge = [&](const auto& visit) {
    for (const InnerFace& face : cells.inner) visit(at(face.owner), at(face.neighbour));
    for (std::size_t i = 0; i < beyond.size(); ++i) visit(at(beyond[i]), tets + i);
  };
  graph.first.assign(nodes + 1, 0);
  for_each_edge([&](std::size_t a, std::size_t b) {
    ++graph.first[a + 1];
    ++graph.first[b + 1];
  });
  for (std::size_t v = 0; v < nodes; ++v) graph.first[v + 1] += graph.first[v];
  graph.neighbour.resize(at(graph.first[nodes]));
  graph.edge_weight.assign(graph.neighbour.size(), 1);
  std::vector<std::int32_t> next(graph.first.begin(), graph.first.end() - 1);
  for_each_edge([&](std::size_t a, std::size_t b) {
    graph.neighbour[at(next[a]++)] = static_cast<std::int32_t>(b);
    graph.neighbour[at(next[b]++)] = static_cast<std::int32_t>(a);
  });
  return graph;
}

}  // namespace tetfarm
