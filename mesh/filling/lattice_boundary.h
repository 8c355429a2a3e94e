/// Which triangles of the boundary are faces of the job's lattice: the middle of cuts along its
/// planes.
///
/// Source: decomposition notes, planes of the {110} family; lattice_core.h. Such planes cross no
/// tet of the lattice, so there the tets of the lattice end at the cut by themselves, and the core
/// may reach it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

struct LatticeBoundary {
  /// By lattice node: the vertex of the boundary in its very place, or -1. Empty without cuts.
  std::vector<std::int32_t> node2vertex;
  /// By triangle: 1 when it is a face of a tet between cells of one size.
  std::vector<std::uint8_t> is_lattice_face;

  bool has_vertex_at(std::size_t node) const {
    return !node2vertex.empty() && node2vertex[node] >= 0;
  }
};

/// Only nodes of cuts are looked for. Cost: O(nodes + triangles).
LatticeBoundary find_lattice_boundary(std::span<const LatticeNode> nodes,
                                      const Subdomain& subdomain);

}  // namespace tetfarm
