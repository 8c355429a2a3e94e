/// What layers leave of the domain: what is cut and filled with tets.
///
/// Source: thesis 4.4, where the top of the layers with the rest of the boundary is the input of
/// the isotropic generator.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/core/surface_mesh.h"
#include "mesh/layers/layer_plan.h"

namespace tetfarm {

/// A sub-domain whose boundary is the top of the layers, and the surface where there are none.
/// Nodes of the top have the origin {owner_of_top, number}, numbered by the lines that have layers
/// and whose tops are no vertices of the surface, in their order; its triangles likewise, by the
/// wall triangles that have cells above them, in the order of `wall`. Triangles keep the order of
/// the surface; those of the sides of layers are not among them, nor those above which layers end
/// on others (LineEnd). What is open of fans comes last.
struct UnlayeredDomain {
  Subdomain root;
  std::vector<std::int32_t> stands_for;  ///< of each triangle of the root, that of the surface
  std::vector<Triangle> lines_of_fans;   ///< of the last triangles of the root
  std::int64_t top_nodes = 0;
  std::int64_t top_triangles = 0;
};
/// Cost: O(n).
UnlayeredDomain unlayered_domain(const LayerPlan& plan, const SurfaceMesh& surface, TreePath path,
                                 std::uint64_t owner_of_top);

}  // namespace tetfarm
