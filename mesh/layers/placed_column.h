/// The cells above a triangle with the places of their corners, before there are any nodes.
#pragma once

#include <array>
#include <vector>

#include "mesh/core/vec3.h"
#include "mesh/layers/layer_cells.h"
#include "mesh/layers/layer_plan.h"

namespace tetfarm {

struct PlacedColumn {
  LayerColumn column;
  std::array<std::vector<Vec3>, 3> points;  ///< of each line, from its foot up
  int layers = 0;                           ///< above the triangle
};

/// Cost: O(layers).
PlacedColumn placed_column(const std::array<const LayerLine*, 3>& lines);

/// Those of a cell of the column, in its order; of the six as many as it has.
std::array<Vec3, 6> corners_of(const PlacedColumn& placed, const LayerCell& cell);

}  // namespace tetfarm
