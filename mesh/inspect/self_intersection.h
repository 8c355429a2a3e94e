/// Pairs of triangles of one surface that share a point which is on no vertex or edge that both
/// have.
#pragma once

#include <optional>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/inspect/surface_report.h"

namespace tetfarm {

/// "self-intersection", among the triangles that the sieve lets through. Exact.
/// @pre those triangles have area and finite corners.
/// Cost: O(n log n + overlapping boxes).
std::optional<SurfaceDefect> check_self_intersection(const SurfaceMesh& surface,
                                                     const std::vector<char>& sieve);

}  // namespace tetfarm
