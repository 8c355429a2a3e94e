/// Moves vertices along the input surface to where their triangles are rounder and as large as
/// wanted.
///
/// Source: M. Botsch and L. Kobbelt, "A remeshing approach to multiresolution modeling" (2004), the
/// fourth step, with the projection onto the input instead of a tangent plane; weights for a
/// spacing that varies as in Q. Du, V. Faber and M. Gunzburger, "Centroidal Voronoi tessellations"
/// (1999).
#pragma once

#include "mesh/remeshing/surface_replacement.h"

namespace tetfarm {

/// Moves a vertex, a smooth one in its face, one on a curve along it, if its worst triangle does
/// not get worse than before and `least_shape`. False: nothing has changed. Cost: some 20 µs.
bool smooth_vertex(RemeshingWork& work, std::int32_t v, double least_shape);

/// All vertices once, in the order of their numbers, but for those round which nothing has changed
/// since they stayed. The number of those that moved.
std::int64_t smooth_vertices(RemeshingWork& work, double least_shape);

/// The spacing at vertices that have moved: it changes little, and is asked for once after some
/// smoothing.
void measure_spacings(RemeshingWork& work);

}  // namespace tetfarm
