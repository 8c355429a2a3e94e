/// The graph of a part's cells, or of columns of them: two are neighbours that share a face.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/formats/cell_faces.h"
#include "mesh/graph/weighted_graph.h"
#include "mesh/partition/cell_columns.h"

namespace tetfarm {

/// Cells are nodes 0 … cells - 1. Behind them are as many more as `beyond` has entries, each with
/// one edge: node cells + i to the cell beyond[i]. All weights are 1. Cost: O(n).
WeightedGraph dual_graph(const CellFaces& faces, std::size_t cells,
                         const std::vector<std::int32_t>& beyond = {});

/// Columns are nodes, weighted by their cells; edges are weighted by shared faces. `beyond` are
/// columns. Of single cells it is the graph above. Cost: O(n log n).
WeightedGraph dual_graph(const CellFaces& faces, const CellColumns& columns,
                         const std::vector<std::int32_t>& beyond = {});

}  // namespace tetfarm
