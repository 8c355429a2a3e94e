/// Moves vertices within their face so that the smallest angle round each is larger.
///
/// Source: L. A. Freitag, M. Jones and P. Plassmann, "An efficient parallel algorithm for mesh
/// smoothing" (1995): the worst angle of a vertex's triangles is made as large as can be. Here by
/// steps along eight directions, as the input surface need not be smooth. Angles are compared by
/// their cosines, which are the same on every machine.
#pragma once

#include "mesh/remeshing/surface_replacement.h"

namespace tetfarm {

/// Moves every smooth vertex round which there is an angle whose cosine is above `cosine_wanted` to
/// where the smallest is larger, while that goes on. Returns how many have moved. Cost: some 50 µs
/// for each such vertex and step.
std::int64_t raise_angles(RemeshingWork& work, double cosine_wanted);

}  // namespace tetfarm
