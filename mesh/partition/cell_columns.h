/// Cells that are to stay in one part: the prisms that stand on one another in layers, which
/// solvers take line by line.
///
/// Source: none in the thesis; solvers that are implicit along lines away from a wall want each
/// line in one process.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/formats/cell_faces.h"

namespace tetfarm {

/// Columns are numbered by their first cells. A cell that stands on none is a column of its own.
struct CellColumns {
  std::vector<std::int32_t> column_of_cell;  ///< counted as in part_cells.h
  std::vector<std::int32_t> sizes;           ///< cells of each column

  bool are_single_cells() const { return sizes.size() == column_of_cell.size(); }
};

CellColumns single_cells(std::size_t cells);

/// Prisms that share a triangle are of one column. Cost: O(n).
CellColumns columns_of_prisms(const NumberedPart& part, const CellFaces& faces);

}  // namespace tetfarm
