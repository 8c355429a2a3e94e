/// The marks of a part's cells when these come in another order.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/core/cell_marks.h"

namespace tetfarm {

/// First those of the cell that order[0] is the number of, counted as in part_cells.h. Marks that
/// no cell has stay so. @pre `order` has each number once. Cost: O(cells).
CellMarks reordered_marks(const CellMarks& marks, const std::vector<std::size_t>& order);

}  // namespace tetfarm
