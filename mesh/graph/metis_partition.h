/// Divides a weighted graph into parts of about equal weight with few edges between them, by METIS.
///
/// METIS draws its random numbers from the C library's rand() after srand(seed): with glibc the
/// answer is the same everywhere and on every day; see
/// docs/decisions/0012-decompose-assimilation.md. The only unit that knows METIS.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/graph/weighted_graph.h"

namespace tetfarm {

struct MetisOptions {
  enum class Method { recursive, k_way, k_way_volume };
  Method method = Method::k_way;
  /// The heaviest part may exceed the mean by so many thousandths; METIS does not always keep it.
  std::int32_t imbalance_in_thousandths = 30;
  std::int32_t trials = 1;  ///< the best of so many is taken
  std::int32_t seed = 20;   ///< another one gives another answer
  /// Parts are to be of one piece each; only k-way can, and only of a graph of one piece.
  bool contiguous = false;
  /// For k_way_volume: what it costs that another part has to know the node. One for each node.
  std::vector<std::int32_t> volume;
};

/// The part of each node, 0 ... parts - 1. Parts may come out empty.
/// @pre 1 <= parts; the sum of all weights fits 31 bits. @throws std::bad_alloc.
/// Cost: O(nodes + edges), times log(parts) for recursive. Not safe with other users of rand().
std::vector<std::int32_t> metis_partition(const WeightedGraph& graph, std::int32_t parts,
                                          const MetisOptions& options);

}  // namespace tetfarm
