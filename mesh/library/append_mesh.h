/// A mesh of a part becomes part of a larger one.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/core/tet_mesh.h"

namespace tetfarm {

/// Appends the tets of `part` to `tets`, and its inner nodes to `nodes`. `part2all`: what its
/// boundary nodes are in `nodes`. Cost: O(n).
/// @pre part2all has part.boundary_nodes entries.
void append_mesh(const TetMesh& part, std::vector<std::int32_t> part2all, std::vector<Vec3>& nodes,
                 std::vector<Tet>& tets);

}  // namespace tetfarm
