/// The graph of a part's tets: two are neighbours that share a face.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/formats/cell_faces.h"
#include "mesh/graph/weighted_graph.h"

namespace tetfarm {

/// Tets are nodes 0 … tets - 1. Behind them are as many more as `beyond` has entries, each with one
/// edge: node tets + i to the tet beyond[i]. All weights are 1. Cost: O(n).
WeightedGraph dual_graph(const CellFaces& cells, std::size_t tets,
                         const std::vector<std::int32_t>& beyond = {});

}  // namespace tetfarm
