#include "mesh/layers/layer_shape.h"

#include <algorithm>
#include <array>
#include <span>

#include "base/array_index.h"

namespace tetfarm {
namespace {

using Corners = std::array<Vec3, 6>;

/// At a corner whose edges are these; 1 where they are at right angles.
double scaled_jacobian(const Vec3& a, const Vec3& b, const Vec3& c) {
  return dot(cross(a, b), c) / (norm(a) * norm(b) * norm(c));
}

double least_at_corners(const Corners& p) {
  double least = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const std::size_t last = (k + 2) % 3;
    least = std::min(least, scaled_jacobian(p[next] - p[k], p[last] - p[k], p[k + 3] - p[k]));
    least = std::min(
        least, scaled_jacobian(p[last + 3] - p[k + 3], p[next + 3] - p[k + 3], p[k] - p[k + 3]));
  }
  return least;
}

/// That of a straight prism on its first three corners: the least sine of their triangle.
double least_of_straight(const Corners& p) {
  double least = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 a = p[(k + 1) % 3] - p[k];
    const Vec3 b = p[(k + 2) % 3] - p[k];
    least = std::min(least, norm(cross(a, b)) / (norm(a) * norm(b)));
  }
  return least;
}

bool is_absorbing(const GrownLayers& layers, std::size_t prism) {
  const std::vector<std::int32_t>& depths = layers.marks[CellMark::pml_depth];
  const std::size_t before =
      layers.mesh.tets.size() + layers.blocks[ElementType::pyramid].regions.size();
  return !depths.empty() && depths[before + prism] > 0;
}

}  // namespace

std::optional<double> least_jacobian_share(const GrownLayers& layers) {
  const std::vector<std::int32_t>& nodes = layers.blocks[ElementType::prism].nodes;
  std::optional<double> least;
  double of_straight = 1;
  for (std::size_t first = 0; first < nodes.size(); first += 6) {
    const auto prism = std::span(nodes).subspan(first, 6);
    if (is_absorbing(layers, first / 6)) continue;
    Corners p;
    for (std::size_t k = 0; k < 6; ++k) p[k] = layers.mesh.nodes[at(prism[k])];
    // Cells come column by column, from the wall up.
    const bool goes_on =
        first > 0 && std::equal(prism.begin(), prism.begin() + 3, prism.begin() - 3);
    if (!goes_on) of_straight = least_of_straight(p);
    const double share = least_at_corners(p) / of_straight;
    least = std::min(least.value_or(share), share);
  }
  return least;
}

}  // namespace tetfarm
