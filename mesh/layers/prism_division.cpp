#include "mesh/layers/prism_division.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace tetfarm {

std::array<std::array<std::uint8_t, 4>, 3> tets_of_prism(const std::array<std::int32_t, 3>& feet) {
  TF_CHECK(feet[0] != feet[1] && feet[1] != feet[2] && feet[2] != feet[0]);
  // Turned, which keeps the tets positive, until the lowest foot is first.
  std::array<std::uint8_t, 3> low = {0, 1, 2};
  while (feet[low[0]] != std::min({feet[0], feet[1], feet[2]})) {
    std::rotate(low.begin(), low.begin() + 1, low.end());
  }
  const auto high = [&low](std::size_t k) { return static_cast<std::uint8_t>(low[k] + 3); };
  if (feet[low[1]] < feet[low[2]]) {
    return {{{low[0], low[1], low[2], high(2)},
             {low[0], low[1], high(2), high(1)},
             {high(0), high(2), high(1), low[0]}}};
  }
  return {{{low[0], low[1], low[2], high(1)},
           {low[2], low[0], high(1), high(2)},
           {high(0), high(2), high(1), low[0]}}};
}

}  // namespace tetfarm
