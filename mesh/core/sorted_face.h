/// The nodes of a face in an order that does not depend on where it begins or which side is seen.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/array_index.h"
#include "mesh/core/tet_mesh.h"

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

template <class Node>
std::array<Node, 3> sorted_face(std::array<Node, 3> nodes) {
  sort_face(nodes);
  return nodes;
}

/// The nodes of the tet's face opposite to its node `face`. @pre 0 <= face < 4
inline std::array<std::int32_t, 3> sorted_face(const Tet& tet, int face) {
  const auto& local = tet_face_nodes[at(face)];
  return sorted_face(std::array{tet[at(local[0])], tet[at(local[1])], tet[at(local[2])]});
}

}  // namespace tetfarm
