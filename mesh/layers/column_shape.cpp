#include "mesh/layers/column_shape.h"

#include <algorithm>
#include <array>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/core/elements.h"
#include "mesh/layers/layer_fan.h"
#include "mesh/layers/layer_shape.h"
#include "mesh/layers/placed_column.h"

namespace tetfarm {
namespace {

/// The layers below the first prism from layer `from` on that has less than its share.
int well_shaped_above(const LayerPlan& plan, const std::array<std::int32_t, 3>& lines, int from,
                      double least) {
  std::array<const LayerLine*, 3> of_plan{};
  for (std::size_t k = 0; k < 3; ++k) of_plan[k] = &plan.lines[at(lines[k])];
  const PlacedColumn placed = placed_column(of_plan);
  double wanted = -1;
  for (int layer = from; layer <= placed.layers; ++layer) {
    for (const LayerCell& cell : cells_of_layer(placed.column, layer)) {
      if (cell.type != ElementType::prism) continue;
      const std::array<Vec3, 6> prism = corners_of(placed, cell);
      const bool is_lowest = wanted < 0;
      if (is_lowest) wanted = least * jacobian_of_straight(prism);
      if (scaled_jacobian(ElementType::prism, prism) < wanted) {
        return is_lowest ? placed.layers : layer - 1;
      }
    }
  }
  return placed.layers;
}

}  // namespace

std::vector<int> well_shaped_layers(const LayerPlan& plan, const SurfaceMesh& surface,
                                    double least) {
  TF_CHECK(least >= 0 && least < 1);
  std::vector<int> stops;
  for (const LayerLine& line : plan.lines) stops.push_back(line.stop);
  const auto look_at = [&](const std::array<std::int32_t, 3>& lines, int from) {
    const int most = well_shaped_above(plan, lines, from, least);
    for (const std::int32_t line : lines) stops[at(line)] = std::min(stops[at(line)], most);
  };
  for (const std::int32_t t : plan.wall) look_at(lines_of(plan, surface, t), 1);
  for (const FanPiece& piece : plan.fans) {
    // The first layer of a piece has no prism.
    for (const auto& [a, b, c] : open_triangles(plan, piece)) look_at({a, b, c}, 2);
  }
  return stops;
}

}  // namespace tetfarm
