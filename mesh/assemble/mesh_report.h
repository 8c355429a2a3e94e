/// Whether a mesh from a file is right, and how well shaped its tets are (`tetfarm quality`).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/hash.h"
#include "mesh/assemble/forced_dihedral.h"
#include "mesh/assemble/mesh_shapes.h"
#include "mesh/core/tet_mesh.h"

namespace tetfarm {

/// A global mesh in memory: each node once. Normals of boundary triangles point out of the domain;
/// triangles between two regions are there once for each, pointing out of it.
struct GlobalMesh {
  TetMesh mesh;
  std::vector<Triangle> boundary;
  std::vector<std::int32_t> patch_of_triangle;
  std::vector<std::string> patch_names;  ///< empty when the file has none
  std::int32_t subdomains = 1;
  /// Of each tet, those of one sub-domain one after the other; empty when the file does not say.
  std::vector<std::int32_t> subdomain_of_tet;
  std::vector<std::int32_t> region_of_triangle;  ///< that it points out of; as region_of_tet
  std::vector<std::int32_t> region_of_tet;       ///< from 1; empty when the file does not say
  std::vector<std::string> region_names;  ///< of region 1, 2, …; empty when the file has none
};

struct MeshReport {
  std::int64_t nodes = 0;
  std::int64_t tets = 0;
  std::int64_t boundary_triangles = 0;
  std::int32_t subdomains = 1;
  double volume = 0;
  double enclosed_volume = 0;
  MeshShapes shapes;
  ForcedDihedral forced;
  std::vector<std::string> region_names;
  Hash128 digest;
  /// What is wrong, a line each, at most twenty: tets without volume, faces that are not shared by
  /// two tets and no boundary triangle, boundary triangles without their tet, an open boundary,
  /// volumes that do not add up to 1e-9. Empty for a right mesh.
  std::vector<std::string> complaints;
};

/// Reads .vtkhdf or .lb8.ugrid by the ending. @throws IoError, InvalidInput (another ending, a file
/// that is no mesh of tets).
GlobalMesh read_global_mesh(const std::filesystem::path& path);

/// Cost: O(n log n); about 100 bytes a tet with the mesh itself.
MeshReport report_on(const GlobalMesh& mesh);

}  // namespace tetfarm
