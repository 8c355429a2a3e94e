/// The nodes of a face in an order that does not depend on where it begins or which side is seen.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

namespace tetfarm {

/// Sorts three nodes; true when that turned them the other way round.
template <class Node>
bool sort_face(std::array<Node, 3>& nodes) {
  bool is_turned = false;
  const auto sort_two = [&](std::size_t i, std::size_t j) {
    if (nodes[i] <= nodes[j]) return;
    std::swap(nodes[i], nodes[j]);
    is_turned = !is_turned;
  };
  sort_two(0, 1);
  sort_two(1, 2);
  sort_two(0, 1);
  return is_turned;
}

}  // namespace tetfarm
