/// Which shell lies inside which.
///
/// Source: the number of times a ray from a shell crosses another is odd when it starts inside. The
/// ray is that of shifted_ray.h, from a vertex.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

struct ShellPlace {
  std::int32_t parent = -1;  // the shell that directly contains it; -1: none
  int depth = 0;             // how many shells contain it
};

/// @pre each shell (triangle numbers) is closed; no two triangles intersect, but shells may share
/// vertices. A shell that shares all its vertices with others is placed by the centre of its first
/// triangle, which is exact only up to rounding. Cost: O(n log n), and for each shell the triangles
/// along a ray.
std::vector<ShellPlace> nest_shells(const SurfaceMesh& surface,
                                    const std::vector<std::vector<std::int32_t>>& shells);

}  // namespace tetfarm
