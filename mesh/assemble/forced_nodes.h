/// Nodes where the surface itself forces small angles on every mesh of it: tets of other nodes only
/// are as good as the mesher makes them, and are judged by themselves (unforced_tets.h).
///
/// Source: none in the thesis. Forced are the corners of triangles with an angle below
/// `forcing_deg`, which are faces of the mesh, and the ends of edges where forced_dihedral.h has a
/// bound below it. Units: degrees.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

inline constexpr double forcing_deg = 15;

/// A vertex of the surface that is forced in one of the regions at it.
struct ForcedNode {
  std::int32_t vertex = 0;
  std::int32_t region = 1;

  friend auto operator<=>(const ForcedNode&, const ForcedNode&) = default;
};

/// Of the whole surface, ascending. Cost: O(n log n); memory of the triangles four times.
std::vector<ForcedNode> forced_nodes(const SurfaceMesh& surface);

}  // namespace tetfarm
