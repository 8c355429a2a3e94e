/// A grid of cells of every type whose cells have marks: the number of each among those of its
/// part. Of five nodes that follow each other four are on the line of the first.
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
      for (const std::int64_t node : part.local2global) {
        const auto depth = static_cast<std::int32_t>(node % 5);
        const bool is_on_line = depth < 4;
        part.feet.add(is_on_line ? node - depth : no_foot, is_on_line ? depth : no_foot);
      }
    }
  }
  std::vector<CellMark> cell_marks() const override { return {CellMark::layer}; }
  bool has_feet() const override { return true; }
};

}  // namespace tetfarm
