/// Puts a vertex on the middle of an edge.
///
/// Source: M. Botsch and L. Kobbelt, "A remeshing approach to multiresolution modeling" (2004), the
/// first step.
#pragma once

#include "mesh/remeshing/surface_replacement.h"

namespace tetfarm {

/// The new vertex goes to the input's face or curve, or stays in the middle of the edge where it
/// may not. False: nothing has changed. Cost: some 10 µs.
bool split_edge(RemeshingWork& work, std::int32_t a, std::int32_t b);

}  // namespace tetfarm
