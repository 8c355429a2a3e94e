// Graphs of leaves without geometry: grids, and random ones from a seed.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>

#include "mesh/assimilation/subdomain_graph.h"

namespace tetfarm::test {

inline SubdomainGraph unconnected_leaves(std::size_t count) {
  SubdomainGraph graph;
  for (std::size_t i = 0; i < count; ++i) {
    graph.path.push_back({count + i});
    graph.work.push_back(100);
    graph.faces.push_back(60);
    graph.interface_nodes.push_back(20);
  }
  graph.neighbours.resize(count);
  return graph;
}

inline void connect(SubdomainGraph& graph, std::int32_t a, std::int32_t b, std::int32_t triangles) {
  const auto add = [&](std::int32_t from, std::int32_t to) {
    auto& list = graph.neighbours[static_cast<std::size_t>(from)];
    const auto place =
        std::lower_bound(list.begin(), list.end(), to,
                         [](const Neighbour& n, std::int32_t leaf) { return n.leaf < leaf; });
    if (place == list.end() || place->leaf != to) list.insert(place, {to, triangles});
  };
  add(a, b);
  add(b, a);
}

/// n x n x n leaves, each sharing ten triangles with those next to it.
inline SubdomainGraph leaf_grid(std::int32_t n) {
  SubdomainGraph graph = unconnected_leaves(static_cast<std::size_t>(n * n * n));
  const auto number = [n](std::int32_t i, std::int32_t j, std::int32_t k) {
    return (i * n + j) * n + k;
  };
  for (std::int32_t i = 0; i < n; ++i) {
    for (std::int32_t j = 0; j < n; ++j) {
      for (std::int32_t k = 0; k < n; ++k) {
        if (i + 1 < n) connect(graph, number(i, j, k), number(i + 1, j, k), 10);
        if (j + 1 < n) connect(graph, number(i, j, k), number(i, j + 1, k), 10);
        if (k + 1 < n) connect(graph, number(i, j, k), number(i, j, k + 1), 10);
      }
    }
  }
  return graph;
}

/// A grid whose leaves differ in work by up to `spread` times, as the leaves of a real tree do.
inline SubdomainGraph uneven_grid(std::int32_t n, double spread, std::uint64_t seed) {
  SubdomainGraph graph = leaf_grid(n);
  std::mt19937_64 random(seed);
  for (double& work : graph.work) {
    work = 1000 * (1 + (spread - 1) * static_cast<double>(random() % 1000) / 1000);
  }
  return graph;
}

}  // namespace tetfarm::test
