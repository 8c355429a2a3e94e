/// Makes vertices one that lie at the same place on open edges.
///
/// OBJ and PLY have a vertex for each texture or normal, and many programs write each patch with
/// vertices of its own: what is closed to look at is then open along seams. Only vertices of edges
/// that are on one triangle are joined, so that closed bodies that touch stay as they are, and only
/// where they are equal as those of STL have to be (vertex_welding.h): to the last bit.
#pragma once

#include <cstdint>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// Each such vertex becomes the first in its place; those that come later stay, without triangles,
/// so that the numbers of all others are those of the file. The number of vertices joined to
/// others. @pre invariant 1 of SurfaceMesh, save that vertices of a triangle may be equal. Cost: a
/// nanosecond a triangle where each edge is on an even number of triangles, else O(n log n).
std::int64_t weld_open_edges(SurfaceMesh& surface);

}  // namespace tetfarm
