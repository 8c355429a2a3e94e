#include "mesh/layers/column_shape.h"

#include <algorithm>
#include <array>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/core/elements.h"
#include "mesh/layers/layer_cells.h"
#include "mesh/layers/layer_fan.h"

namespace tetfarm {
namespace {

using PrismCorners = std::array<Vec3, 6>;

double jacobian_of(const PrismCorners& prism) { return scaled_jacobian(ElementType::prism, prism); }

double jacobian_straight_on(const PrismCorners& p) {
  const Vec3 up = normalized(cross(p[1] - p[0], p[2] - p[0]));
  return jacobian_of({p[0], p[1], p[2], p[0] + up, p[1] + up, p[2] + up});
}

/// The layers below the first prism from layer `from` on that has less than its share.
int well_shaped_above(const LayerPlan& plan, const std::array<std::int32_t, 3>& lines, int from,
                      double least) {
  LayerColumn column;
  std::array<std::vector<Vec3>, 3> points;
  for (std::size_t k = 0; k < 3; ++k) {
    const LayerLine& line = plan.lines[at(lines[k])];
    column.stops[k] = line.stop;
    column.early[k] = line.early;
    points[k] = points_of(line);
  }
  const int layers = layers_above(column.stops);
  double wanted = -1;
  for (int layer = from; layer <= layers; ++layer) {
    for (const LayerCell& cell : cells_of_layer(column, layer)) {
      if (cell.type != ElementType::prism) continue;
      PrismCorners p;
      for (std::size_t k = 0; k < p.size(); ++k) {
        p[k] = points[at(cell.nodes[k].corner)][at(cell.nodes[k].level)];
      }
      const bool is_lowest = wanted < 0;
      if (is_lowest) wanted = least * jacobian_straight_on(p);
      if (jacobian_of(p) < wanted) return is_lowest ? layers : layer - 1;
    }
  }
  return layers;
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
