/// Boundary recovery in the plane: makes an edge between two nodes of a triangulation appear by
/// swapping the edges that cross it.
///
/// Source: thesis 3.1 (boundary recovery by edge swapping); S. W. Sloan (1993).
#pragma once

#include <optional>

#include "mesh/planar/planar_mesh.h"
#include "mesh/planar/triangle_complex.h"

namespace tetfarm {

/// Makes edge a-b and constrains it; gives the failure, and leaves the triangles alone, when a node
/// lies on it or a constrained edge crosses it.
/// @pre all triangles round a and b are there (both nodes are inside the triangulation).
/// Cost: the square of the edges crossed at worst, in practice near their number.
std::optional<PlanarFailure> recover_edge(TriangleComplex& complex, std::int32_t a, std::int32_t b);

}  // namespace tetfarm
