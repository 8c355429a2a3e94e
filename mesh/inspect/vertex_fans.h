/// Vertices at which a surface touches itself: more than one fan of triangles meets there.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/inspect/surface_edges.h"

namespace tetfarm {

/// The vertices, sorted, whose triangles are not all joined through edges at that vertex. They can
/// be meshed; the report names them. Cost: O(n).
std::vector<std::int32_t> vertices_of_several_fans(const SurfaceMesh& surface,
                                                   std::span<const EdgeUse> uses);

}  // namespace tetfarm
