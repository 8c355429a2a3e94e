/// Coarser and coarser graphs by joining neighbours in pairs, as the first half of a multi-level
/// partition: METIS's own way, for a graph that is one part of a larger one.
///
/// Pairs are chosen by heavy edges between light nodes, so that what is joined stays round and of
/// even weight. Deterministic: nodes are visited by weight, then in an order scrambled by a fixed
/// hash of their numbers, which does not follow the numbering as stripes would.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/graph/weighted_graph.h"

namespace tetfarm {

/// The first `movable` nodes may be joined; the others stay what they are, at the end.
struct GraphLevel {
  WeightedGraph graph;
  std::size_t movable = 0;
  std::vector<std::int32_t> coarse_of;  ///< of each node of the finer level; empty at the finest
};

/// The graph itself, then coarser ones, until not more than `wanted` movable nodes are left or
/// hardly any can be joined. What becomes of movable nodes does not depend on the others.
/// Every node of a coarser level is of one piece.
/// Cost: O(nodes log nodes + edges), memory of about two of the graph.
std::vector<GraphLevel> coarsen_graph(WeightedGraph graph, std::size_t movable, std::size_t wanted);

}  // namespace tetfarm
