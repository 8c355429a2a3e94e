/// Booleans of boxes and prisms, exact: solids of cells that are in or out. Each box of a grid of
/// uneven lines is parted by its diagonals into four wedges, upright three-sided prisms, so that
/// upright prisms with slanting sides can be had too.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm::shapes {

/// Even whole numbers that grow: where the grid's lines are, for each axis.
using GridLines = std::array<std::vector<std::int64_t>, 3>;

class PrismGrid {
 public:
  /// All cells are out. @pre two lines for each axis at least.
  explicit PrismGrid(GridLines lines);

  /// Boxes along an axis.
  int size(std::size_t axis) const { return static_cast<int>(lines_[axis].size()) - 1; }

  /// Puts those cells in, or out, whose middle the function accepts: x and y in sixths of a box, z
  /// in boxes.
  void set(bool is_in, const std::function<bool(int x6, int y6, int z)>& accepts);

  /// Cells that meet in an edge only get others beside them, until none do.
  void thicken_edges();

  /// The skin, with the small triangles of the cells. @pre thicken_edges was called.
  SurfaceMesh surface() const;

  bool is_empty() const;

 private:
  using Cell = std::array<int, 4>;  // box and wedge: 0 below (small y), then anticlockwise
  using Node = std::array<int, 3>;  // x and y in halves of a box, z in boxes

  std::size_t index(const Cell& cell) const;
  bool holds(const Cell& cell) const;
  void for_each_cell(const std::function<void(const Cell&)>& visit) const;
  std::array<Cell, 5> neighbours(const Cell& cell) const;
  static std::array<Node, 6> corners(const Cell& cell);
  std::vector<std::array<Node, 3>> skin() const;

  GridLines lines_;
  std::vector<char> is_in_;
};

}  // namespace tetfarm::shapes
