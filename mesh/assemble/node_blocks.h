/// The nodes of a part's tets by their numbers in the whole mesh, in blocks that stay in the
/// processor's caches until they are written.
#pragma once

#include <algorithm>
#include <vector>

#include "mesh/assemble/portion.h"

namespace tetfarm {

/// Calls visit(nodes) with those of the next tets, four each, counted from `from`.
/// @pre numbers fit into `Integer`. Cost: O(n); memory of a block.
template <class Integer, class Visit>
void for_each_block_of_nodes(const NumberedPart& part, Integer from, const Visit& visit) {
  constexpr std::size_t tets_of_block = 16384;
  std::vector<Integer> nodes;
  const std::int64_t* const local2global = part.local2global.data();
  for (std::size_t first = 0; first < part.tets.size(); first += tets_of_block) {
    const std::size_t last = std::min(first + tets_of_block, part.tets.size());
    nodes.resize(4 * (last - first));
    Integer* next = nodes.data();
    for (std::size_t t = first; t < last; ++t) {
      for (const std::int32_t v : part.tets[t]) {
        *next++ = static_cast<Integer>(local2global[v]) + from;
      }
    }
    visit(nodes);
  }
}

}  // namespace tetfarm
