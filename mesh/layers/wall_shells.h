/// The closed parts of patches that layers grow from as a whole, as absorbing ones do.
///
/// Source: thesis 4.4.3, which takes the outer boundary whole.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/layers/wall_graph.h"

namespace tetfarm {

/// One closed part of the patches.
struct ClosedShell {
  std::vector<std::int32_t> vertices;  ///< of the surface, ascending
  std::vector<Triangle> triangles;     ///< of their vertices
};

/// The graph of the patches, one line at each vertex. @param patches of the surface, ascending.
/// @throws UsageError naming the place where the patches do not close. Cost: O(n log n).
WallGraph graph_of_whole_shells(const SurfaceMesh& surface, std::span<const std::int32_t> patches);

/// In the order of their first vertices. @pre the graph is one of whole shells. Cost: O(n).
std::vector<ClosedShell> shells_of(const SurfaceMesh& surface, const WallGraph& graph);

/// Of a triangle of a shell: away from the domain, of length 1.
Vec3 outward_normal(const SurfaceMesh& surface, const Triangle& t);

}  // namespace tetfarm
