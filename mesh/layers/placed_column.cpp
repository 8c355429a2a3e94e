#include "mesh/layers/placed_column.h"

#include "base/array_index.h"

namespace tetfarm {

PlacedColumn placed_column(const std::array<const LayerLine*, 3>& lines) {
  PlacedColumn placed;
  for (std::size_t k = 0; k < 3; ++k) {
    placed.column.stops[k] = lines[k]->stop;
    placed.column.early[k] = lines[k]->early;
    placed.points[k] = points_of(*lines[k]);
  }
  placed.layers = layers_above(placed.column.stops);
  return placed;
}

std::array<Vec3, 6> corners_of(const PlacedColumn& placed, const LayerCell& cell) {
  std::array<Vec3, 6> corners;
  for (std::size_t k = 0; k < nodes_of(cell.type); ++k) {
    corners[k] = placed.points[at(cell.nodes[k].corner)][at(cell.nodes[k].level)];
  }
  return corners;
}

}  // namespace tetfarm
