#include "mesh/layers/layer_cells.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

using ComponentTet = std::array<std::uint8_t, 4>;

/// The corners of a wall triangle, anticlockwise seen from the layers.
constexpr std::array<int, 3> seen_from_layers = {0, 2, 1};

/// A triangle with each of the other's corners, the other triangle likewise, and an edge with each
/// edge opposite but its own.
constexpr std::array<ComponentTet, 12> prism_tets = {{{0, 1, 2, 3},
                                                      {0, 1, 2, 4},
                                                      {0, 1, 2, 5},
                                                      {3, 5, 4, 0},
                                                      {3, 5, 4, 1},
                                                      {3, 5, 4, 2},
                                                      {0, 1, 5, 4},
                                                      {0, 1, 5, 3},
                                                      {1, 2, 3, 5},
                                                      {1, 2, 3, 4},
                                                      {2, 0, 4, 3},
                                                      {2, 0, 4, 5}}};
/// Of both diagonals of the base.
constexpr std::array<ComponentTet, 4> pyramid_tets = {
    {{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 1, 3, 4}, {1, 2, 3, 4}}};
constexpr std::array<ComponentTet, 1> whole_tet = {{{0, 1, 2, 3}}};

}  // namespace

int layers_above(const std::array<int, 3>& stops) {
  return *std::max_element(stops.begin(), stops.end());
}

namespace {

/// The cell where those of three lines go on that `grow`, from the levels that they have reached.
LayerCell cell_between(const std::array<int, 3>& reached, const std::array<bool, 3>& grow,
                       int layer) {
  const auto grows = [&](int corner) { return grow[at(corner)]; };
  const auto low = [&](int corner) { return CellNode{corner, reached[at(corner)]}; };
  const auto high = [&](int corner) { return CellNode{corner, layer}; };
  // Turned until the first grows, and the last does not where one does not.
  std::array<int, 3> c = seen_from_layers;
  while (!grows(c[0]) || (grows(c[2]) && !grows(c[1]))) {
    std::rotate(c.begin(), c.begin() + 1, c.end());
  }
  if (grows(c[1]) && grows(c[2])) {
    return {ElementType::prism,
            layer,
            {low(c[0]), low(c[1]), low(c[2]), high(c[0]), high(c[1]), high(c[2])}};
  }
  if (grows(c[1])) {
    return {ElementType::pyramid, layer, {low(c[0]), high(c[0]), high(c[1]), low(c[1]), low(c[2])}};
  }
  return {ElementType::tet, layer, {low(c[0]), low(c[1]), low(c[2]), high(c[0])}};
}

}  // namespace

LayerCell layer_cell(const std::array<int, 3>& stops, int layer) {
  TF_CHECK(layer >= 1 && layer <= layers_above(stops));
  std::array<int, 3> reached{};
  std::array<bool, 3> grow{};
  for (std::size_t k = 0; k < 3; ++k) {
    reached[k] = std::min(stops[k], layer - 1);
    grow[k] = stops[k] >= layer;
  }
  return cell_between(reached, grow, layer);
}

CellsOfLayer cells_of_layer(const LayerColumn& column, int layer) {
  std::array<int, 3> reached{};
  std::array<int, 3> reached_early{};
  std::array<bool, 3> first{};
  std::array<bool, 3> then{};
  for (std::size_t k = 0; k < 3; ++k) {
    const bool grows = column.stops[k] >= layer;
    first[k] = grows && column.early[k];
    then[k] = grows && !column.early[k];
    reached[k] = std::min(column.stops[k], layer - 1);
    reached_early[k] = first[k] ? layer : reached[k];
  }
  const std::array<bool, 3> none{};
  if (first == none || then == none) return {{layer_cell(column.stops, layer)}, 1};
  return {{cell_between(reached, first, layer), cell_between(reached_early, then, layer)}, 2};
}

std::span<const ComponentTet> component_tets(ElementType type) {
  TF_CHECK(is_cell(type) && type != ElementType::hex);
  if (type == ElementType::prism) return prism_tets;
  if (type == ElementType::pyramid) return pyramid_tets;
  return whole_tet;
}

bool is_positive(ElementType type, std::span<const Vec3> nodes) {
  const auto tets = component_tets(type);
  return std::all_of(tets.begin(), tets.end(), [nodes](const ComponentTet& tet) {
    return orient3d(nodes[tet[0]], nodes[tet[1]], nodes[tet[2]], nodes[tet[3]]) > 0;
  });
}

}  // namespace tetfarm
