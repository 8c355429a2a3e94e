#include "mesh/layers/layer_shape.h"

#include <algorithm>
#include <array>
#include <span>

#include "base/array_index.h"
#include "mesh/core/elements.h"

namespace tetfarm {
namespace {

bool is_absorbing(const GrownLayers& layers, std::size_t prism) {
  const std::vector<std::int32_t>& depths = layers.marks[CellMark::pml_depth];
  const std::size_t before =
      layers.mesh.tets.size() + layers.blocks[ElementType::pyramid].regions.size();
  return !depths.empty() && depths[before + prism] > 0;
}

}  // namespace

double jacobian_of_straight(const std::array<Vec3, 6>& p) {
  const Vec3 up = normalized(cross(p[1] - p[0], p[2] - p[0]));
  const std::array<Vec3, 6> straight = {p[0], p[1], p[2], p[0] + up, p[1] + up, p[2] + up};
  return scaled_jacobian(ElementType::prism, straight);
}

std::vector<double> jacobian_shares(const GrownLayers& layers) {
  const std::vector<std::int32_t>& nodes = layers.blocks[ElementType::prism].nodes;
  std::vector<double> shares;
  double of_straight = 1;
  std::array<std::int32_t, 3> top_of_last = {-1, -1, -1};
  for (std::size_t first = 0; first < nodes.size(); first += 6) {
    const auto prism = std::span(nodes).subspan(first, 6);
    std::array<Vec3, 6> p;
    for (std::size_t k = 0; k < 6; ++k) p[k] = layers.mesh.nodes[at(prism[k])];
    // Cells come column by column, from the wall up.
    const bool goes_on = std::equal(top_of_last.begin(), top_of_last.end(), prism.begin());
    std::copy(prism.begin() + 3, prism.end(), top_of_last.begin());
    if (!goes_on) of_straight = jacobian_of_straight(p);
    if (is_absorbing(layers, first / 6)) continue;
    shares.push_back(scaled_jacobian(ElementType::prism, p) / of_straight);
  }
  return shares;
}

}  // namespace tetfarm
