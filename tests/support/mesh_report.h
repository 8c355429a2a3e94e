/// Whether a mesh in memory is right, and how well shaped its tets are: what `check_mesh`
/// (mesh/check) and `figures_of` (mesh/figures) tell part by part, told of all at once, by other
/// code.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/hash.h"
#include "mesh/assemble/mesh_in_memory.h"
#include "mesh/assemble/mesh_shapes.h"

namespace tetfarm {

struct MeshReport {
  std::int64_t nodes = 0;
  std::int64_t tets = 0;
  std::int64_t boundary_triangles = 0;
  std::int32_t subdomains = 1;
  double volume = 0;
  MeshShapes shapes;
  Hash128 digest;
  /// What is wrong, a line each, at most twenty: tets without volume, faces that are not shared by
  /// two tets and no boundary triangle, boundary triangles without their tet, an open boundary,
  /// volumes that do not add up to 1e-9. Empty for a right mesh.
  std::vector<std::string> complaints;
};

/// Cost: O(n log n); about 100 bytes a tet with the mesh itself.
MeshReport report_on(const GlobalMesh& mesh);

}  // namespace tetfarm
