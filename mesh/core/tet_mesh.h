/// A tetrahedral mesh of one sub-domain, as the mesh task publishes it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

using Tet = std::array<std::int32_t, 4>;

/// The faces of a positive tet (a, b, c, d) have outward normals in this order; face i is opposite
/// node i.
inline constexpr std::array<std::array<int, 3>, 4> tet_face_nodes = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// Invariants (validate): 1. the first `boundary_nodes` nodes are the sub-domain's vertices, in its
/// order and bit by bit; the rest are interior; 2. every tet has exactly positive volume;
/// 3. every face is shared by two tets in opposite directions, or is a boundary triangle of the
/// sub-domain, and every boundary triangle is such a face, once; 4. every node is used.
struct TetMesh {
  std::vector<Vec3> nodes;
  std::vector<Tet> tets;
  std::int32_t boundary_nodes = 0;
};

}  // namespace tetfarm
