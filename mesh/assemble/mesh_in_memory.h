/// A mesh as a whole, for who cannot take it a part at a time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/core/tet_mesh.h"

namespace tetfarm {

/// Each node once. Normals of boundary triangles point out of the domain; triangles between two
/// regions are there once for each, pointing out of it.
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

}  // namespace tetfarm
