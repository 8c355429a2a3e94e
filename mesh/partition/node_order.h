/// Orders in which nodes that are neighbours in a mesh have numbers near each other.
///
/// Source: E. Cuthill, J. McKee, "Reducing the bandwidth of sparse symmetric matrices" (1969),
/// reversed after A. George (1971); the node to begin at: A. George, J. W. H. Liu, "An
/// implementation of a pseudoperipheral node finder" (1979).
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/assemble/portion.h"

namespace tetfarm {

/// All nodes of a part, piece after piece of the mesh, each in reverse Cuthill-McKee order; ties by
/// degree, then by number. Neighbours are joined by an edge of a cell: not across a quad.
/// Cost: O(n log n).
std::vector<std::int32_t> reverse_cuthill_mckee(const NumberedPart& part);

/// How far apart the numbers of neighbours are: what caches and band solvers feel.
struct NumberSpans {
  std::int64_t edges = 0;
  std::int64_t bandwidth = 0;  ///< the largest difference
  double sum = 0;
  double mean() const { return edges > 0 ? sum / static_cast<double>(edges) : 0; }
  void add(const NumberSpans& other);
};

/// Over the edges of the cells, each once. Cost: O(n log n).
NumberSpans number_spans(const NumberedPart& part);

}  // namespace tetfarm
