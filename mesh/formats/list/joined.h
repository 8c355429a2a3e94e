/// Joins arrays at compile time: the formats of all folders in one table.
#pragma once

#include <array>
#include <cstddef>

namespace tetfarm {

/// The elements of the first, then of the second, …
template <class Element, std::size_t... sizes>
constexpr auto joined(const std::array<Element, sizes>&... arrays) {
  std::array<Element, (sizes + ...)> all = {};
  std::size_t next = 0;
  const auto add = [&](const auto& array) {
    for (const Element& element : array) all[next++] = element;
  };
  (add(arrays), ...);
  return all;
}

}  // namespace tetfarm
