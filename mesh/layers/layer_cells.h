/// The cells above one triangle of the wall, from how many layers its three lines have.
///
/// Source: thesis 4.4, the rule of nodes: where all three lines go on the cell of a layer is a
/// prism, where two do a pyramid, where one does a tet. So neighbours agree on the face between
/// them whatever their third lines do, and the top has triangles alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "mesh/core/elements.h"
#include "mesh/core/vec3.h"

namespace tetfarm {

/// A node of a cell: a corner of the wall triangle, and the level on its line.
struct CellNode {
  int corner = 0;
  int level = 0;

  friend bool operator==(const CellNode&, const CellNode&) = default;
};

/// As many nodes count as the type has, in the order of elements.h.
struct LayerCell {
  ElementType type = ElementType::tet;
  int layer = 1;  ///< from the wall, which it is in
  std::array<CellNode, 6> nodes{};
};

/// The cell of a layer (from 1); nothing has grown there when no stop is that high.
/// @pre some stop is at least `layer`. The triangle's normal points away from the layers.
LayerCell layer_cell(const std::array<int, 3>& stops, int layer);

/// The lines above a triangle: how many layers each has, and which are early (LayerLine).
struct LayerColumn {
  std::array<int, 3> stops{};
  std::array<bool, 3> early{};
};

/// One cell, or two where some of the lines that go on are early: first these do, and then the
/// others, so that what is beside an early line is pyramids and tets.
struct CellsOfLayer {
  std::array<LayerCell, 2> cells{};
  std::size_t count = 0;

  auto begin() const { return cells.begin(); }
  auto end() const { return cells.begin() + static_cast<std::ptrdiff_t>(count); }
};

/// @pre as layer_cell.
CellsOfLayer cells_of_layer(const LayerColumn& column, int layer);

/// How many layers there are above the triangle.
int layers_above(const std::array<int, 3>& stops);

/// The tets of every division of a cell into tets that has no further node, by the cell's nodes.
std::span<const std::array<std::uint8_t, 4>> component_tets(ElementType type);

/// Whether each of them is positive, by an exact test. @pre `nodes` has those of the type, at
/// least.
bool is_positive(ElementType type, std::span<const Vec3> nodes);

}  // namespace tetfarm
