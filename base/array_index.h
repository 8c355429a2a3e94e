/// A signed number of the mesh (a node, a tet, an element) as the index of an array.
///
/// Numbers are signed because -1 means none; indices of the standard library are not. Cost: none.
#pragma once

#include <concepts>
#include <cstddef>

namespace tetfarm {

/// @pre 0 <= number
template <std::integral Number>
constexpr std::size_t at(Number number) {
  return static_cast<std::size_t>(number);
}

}  // namespace tetfarm
