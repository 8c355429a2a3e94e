/// Recovers a missing edge inside a flat part of the surface by flips in that plane.
///
/// Where the edge crosses nothing but edges of the complex that lie in one plane with it, they are
/// swapped one after the other, each inside the quadrilateral of its two triangles in the plane,
/// until the edge is one of them. On each side of the plane the tets round a swapped edge are
/// triangulated anew, or joined to a point put among them: near the place where the two diagonals
/// cross there is always one that sees all of them. So it ends, and leaves no point on the surface.
/// Source: S. W. Sloan, "A fast algorithm for generating constrained Delaunay triangulations"
/// (1993), for the order of the swaps. Cost: as the square of the edges that are crossed, at most;
/// a ring for each swap.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/recovery/local_remeshing.h"
#include "mesh/recovery/recovery_surface.h"

namespace tetfarm {

/// True when ab is an edge of the complex now; the points that it took are added to `inside`.
/// False: something else is in the way, or a point had no room in 106 bits; nothing has changed.
/// The journal is forgotten. @pre ab is no edge of the complex.
bool recover_edge_in_facet(LocalRemeshing& mesh, const RecoverySurface& surface, std::int32_t a,
                           std::int32_t b, std::vector<std::int32_t>& inside);

}  // namespace tetfarm
