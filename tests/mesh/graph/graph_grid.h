/// A grid of n x n nodes of weight 1, each joined with its neighbours by edges of weight 1.
#pragma once

#include "mesh/graph/weighted_graph.h"

namespace tetfarm::test {

inline WeightedGraph graph_grid(std::int32_t n) {
  WeightedGraph graph;
  for (std::int32_t y = 0; y < n; ++y) {
    for (std::int32_t x = 0; x < n; ++x) {
      const auto join = [&](std::int32_t u, std::int32_t v) {
        if (u < 0 || v < 0 || u >= n || v >= n) return;
        graph.neighbour.push_back(v * n + u);
        graph.edge_weight.push_back(1);
      };
      join(x, y - 1);
      join(x - 1, y);
      join(x + 1, y);
      join(x, y + 1);
      graph.first.push_back(static_cast<std::int32_t>(graph.neighbour.size()));
      graph.weight.push_back(1);
    }
  }
  return graph;
}

}  // namespace tetfarm::test
