/// Nodes where the surface itself forces small angles on every mesh of it: tets of other nodes only
/// are as good as the mesher makes them, and are judged by themselves.
///
/// Source: none in the thesis. Forced are the corners of triangles with an angle below
/// `forcing_deg`, which are faces of the mesh, and the ends of edges where forced_dihedral.h has a
/// bound below it. Units: degrees.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/assemble/global_numbering.h"
#include "mesh/assemble/portion.h"
#include "mesh/core/surface_mesh.h"

namespace tetfarm {

inline constexpr double forcing_deg = 15;

/// Of each vertex of the surface whether it is forced, as far as `is_wanted` (of each vertex) says:
/// others are told not to be. Of the triangles that bound the region count those that have a wanted
/// vertex, so that the answer for these is the same, whatever else is wanted.
/// @pre is_wanted has an entry for each vertex. Cost: O(n), and O(m log m) of the m that count.
std::vector<bool> forced_nodes(const SurfaceMesh& surface, std::int32_t region,
                               const std::vector<bool>& is_wanted);

/// The tets of a sub-domain that have no forced node, as far as their angles go.
struct UnforcedTets {
  std::int64_t tets = 0;
  double min_dihedral_deg = 180;
  Vec3 worst_centroid;  ///< of the first with the smallest angle
};

/// @pre the portion is of that surface and numbering, and has its tets. Cost: as forced_nodes, and
/// O(tets) where a node is forced.
UnforcedTets unforced_tets(const Portion& portion, const SurfaceMesh& surface,
                           const Numbering& numbering);

}  // namespace tetfarm
