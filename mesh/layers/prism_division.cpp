#include "mesh/layers/prism_division.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace tetfarm {

LineOrder order_of(const LayerLine& line, std::uint32_t top) {
  TF_CHECK(line.stop > 0);
  if (line.vertices > 0) return {line.foot, 0, line.first_vertex};
  return {line.foot, 1, top};
}

std::array<std::array<std::uint8_t, 4>, 3> tets_of_prism(const std::array<std::int32_t, 3>& order) {
  TF_CHECK(order[0] != order[1] && order[1] != order[2] && order[2] != order[0]);
  // Turned, which keeps the tets positive, until the first line is first.
  std::array<std::uint8_t, 3> low = {0, 1, 2};
  while (order[low[0]] != std::min({order[0], order[1], order[2]})) {
    std::rotate(low.begin(), low.begin() + 1, low.end());
  }
  const auto high = [&low](std::size_t k) { return static_cast<std::uint8_t>(low[k] + 3); };
  if (order[low[1]] < order[low[2]]) {
    return {{{low[0], low[1], low[2], high(2)},
             {low[0], low[1], high(2), high(1)},
             {high(0), high(2), high(1), low[0]}}};
  }
  return {{{low[0], low[1], low[2], high(1)},
           {low[2], low[0], high(1), high(2)},
           {high(0), high(2), high(1), low[0]}}};
}

std::array<std::array<std::uint8_t, 4>, 2> tets_of_pyramid(std::size_t corner) {
  TF_CHECK(corner < 4);
  if (corner % 2 == 0) return {{{0, 1, 2, 4}, {0, 2, 3, 4}}};
  return {{{0, 1, 3, 4}, {1, 2, 3, 4}}};
}

}  // namespace tetfarm
