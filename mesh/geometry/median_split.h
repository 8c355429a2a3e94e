/// How trees of boxes divide what they hold: at the median of the centres along one axis.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "mesh/core/vec3.h"

namespace tetfarm {

/// Puts the first half of the items, numbers of boxes, before the others; of an odd count the
/// first is smaller. Ties are broken by number, so that the two halves do not depend on how
/// nth_element works. Returns how many are in the first half. Cost: O(n).
inline std::size_t split_at_median(std::span<std::int32_t> items, std::span<const Box3> boxes,
                                   int axis) {
  const std::size_t half = items.size() / 2;
  const auto less = [boxes, axis](std::int32_t a, std::int32_t b) {
    const Box3& box_a = boxes[static_cast<std::size_t>(a)];
    const Box3& box_b = boxes[static_cast<std::size_t>(b)];
    const double at_a = box_a.low[axis] + box_a.high[axis];
    const double at_b = box_b.low[axis] + box_b.high[axis];
    return at_a < at_b || (at_a == at_b && a < b);
  };
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                   less);
  return half;
}

}  // namespace tetfarm
