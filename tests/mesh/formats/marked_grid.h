/// A grid of cells of every type whose cells have marks: the number of each among those of its
/// part.
#pragma once

#include <numeric>
#include <vector>

#include "mesh/assemble/part_cells.h"
#include "tests/support/hybrid_grid.h"

namespace tetfarm {

class MarkedGrid : public HybridGrid {
 public:
  MarkedGrid() : HybridGrid(4, 2) {
    for (NumberedPart& part : parts) {
      std::vector<std::int32_t>& marks = part.marks[CellMark::layer];
      marks.resize(static_cast<std::size_t>(cells_of(part)));
      std::iota(marks.begin(), marks.end(), 1);
    }
  }
  std::vector<CellMark> cell_marks() const override { return {CellMark::layer}; }
};

}  // namespace tetfarm
