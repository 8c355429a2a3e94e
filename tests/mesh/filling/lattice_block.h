/// A domain whose whole boundary consists of faces of the lattice, as in the middle of cuts.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <map>

#include "base/array_index.h"
#include "mesh/filling/lattice_core.h"
#include "tests/mesh/filling/lattice_cases.h"

namespace tetfarm {

/// A rhombic dodecahedron of lattice tets: all its faces lie in planes of the lattice, as cuts do.
struct LatticeBlock {
  explicit LatticeBlock(std::int32_t half_cells)
      : field(lattice_cases::uniform()), nodes(field.lattice_nodes(lattice_cases::box())) {
    const LatticeNode& middle = *std::min_element(
        nodes.begin(), nodes.end(),
        [](const LatticeNode& a, const LatticeNode& b) { return norm2(a.at) < norm2(b.at); });
    std::vector<std::uint8_t> is_core;
    for (const LatticeNode& node : nodes) {
      is_core.push_back(depth(node, middle) < half_cells ? 1 : 0);
    }
    core = LatticeCore(LatticeGrid(nodes), is_core);
    std::map<std::int32_t, std::int32_t> node2vertex;
    for (const CoreHullFace& face : core.hull()) {
      Triangle triangle;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t node = face.tet[at(tet_face_nodes[at(face_of(face.face))][k])];
        const auto number = static_cast<std::int32_t>(node2vertex.size());
        const auto [entry, is_new] = node2vertex.emplace(node, number);
        if (is_new) {
          domain.vertices.push_back(nodes[at(node)].at);
          domain.node_origin.push_back({1, static_cast<std::uint32_t>(number)});
        }
        triangle[k] = entry->second;
      }
      domain.triangle_origin.push_back({1, static_cast<std::uint32_t>(domain.triangles.size())});
      domain.triangles.push_back(triangle);
    }
  }

  /// Of the largest dodecahedron that does not hold the node.
  static std::int32_t depth(const LatticeNode& node, const LatticeNode& middle) {
    std::array<std::int32_t, 3> d;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      d[axis] = std::abs(node.grid[axis] - middle.grid[axis]) >> (node.cell_bits - 1);
    }
    return std::max({d[0] + d[1], d[1] + d[2], d[2] + d[0]}) / 2;
  }

  SpacingField field;
  std::vector<LatticeNode> nodes;
  LatticeCore core;
  Subdomain domain;
};

}  // namespace tetfarm
