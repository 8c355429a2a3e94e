/// Edge swaps until the triangulation is constrained Delaunay.
///
/// Source: C. L. Lawson, "Software for C1 surface interpolation" (1977); thesis 3.1.
#pragma once

#include <vector>

#include "mesh/planar/triangle_complex.h"

namespace tetfarm {

/// Swaps every unconstrained edge whose two triangles are not locally Delaunay, until none is left.
/// Cocircular points stay as they are. Returns the number of swaps.
/// Cost: O(n) and the swaps, O(n^2) at worst.
std::size_t flip_to_delaunay(TriangleComplex& complex);

/// Whether the edge is constrained, or no circumcircle of its two triangles holds the other's apex.
bool is_locally_delaunay(const TriangleComplex& complex, EdgeHandle edge);

}  // namespace tetfarm
