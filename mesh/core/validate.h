/// The checks that every mesh passes before it is published and after it is read.
#pragma once

#include <string>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/core/tet_mesh.h"

namespace tetfarm {

/// What is wrong with a volume mesh of the domain bounded by `triangles` (indices into mesh.nodes),
/// a line each with numbers and coordinates (at most 20 lines); empty when the invariants of
/// TetMesh hold and the volumes of the tets add up to the enclosed volume to 1e-9 relative. A
/// volume must be positive as computed in long double, or else in 113 bits.
/// Faces are compared by a sum of hashes first, which wrong faces pass once in 2^64 times; only
/// when that does not come out are they sorted, to be named. Cost: O(n) for n tets, and for what is
/// wrong O(n log n) and about 60 bytes a tet.
std::vector<std::string> validate(const TetMesh& mesh, const std::vector<Triangle>& triangles);

/// The edges of a surface that are not used equally often in both directions.
/// Empty for a closed, consistently oriented surface.
std::vector<std::array<std::int32_t, 2>> unmatched_edges(const std::vector<Triangle>& triangles);

}  // namespace tetfarm
