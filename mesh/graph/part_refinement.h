/// Mends a division of a graph into parts: parts of one piece each, none too heavy, and fewer edges
/// between them.
///
/// Nodes move one by one to a neighbouring part, greedily, as at the finest level of METIS; unlike
/// there a node stays whose move might break its part in two. Deterministic: nodes are tried in
/// their order, ties go to the lighter part, then to the lower one.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/graph/weighted_graph.h"

namespace tetfarm {

/// Of each part the heaviest piece stays; the others go to the parts that they share most edges
/// with. A piece that touches no other part stays: the graph itself is then in pieces.
/// Cost: O(nodes + edges), times the longest chain of pieces that touch each other only.
void join_pieces(const WeightedGraph& graph, std::int32_t parts,
                 std::vector<std::int32_t>& part_of_node);

struct PartRefinement {
  /// No part is made heavier; from one that is, nodes move also when that makes the cut longer.
  std::int64_t heaviest = 0;
  int passes = 8;
};

/// Only the first `movable` nodes move; the others are there to be seen, and nothing is assumed of
/// what lies behind them. `weights` are those of the parts, which may have nodes elsewhere, and are
/// kept up to date. Parts of one piece stay so, and no part becomes empty.
/// Cost: O(passes * edges).
void refine_parts(const WeightedGraph& graph, std::size_t movable, const PartRefinement& options,
                  std::vector<std::int32_t>& part_of_node, std::vector<std::int64_t>& weights);

}  // namespace tetfarm
