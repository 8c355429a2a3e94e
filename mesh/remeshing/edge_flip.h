/// Gives the two triangles on an edge the other diagonal.
///
/// Source: C. L. Lawson, "Software for C1 surface interpolation" (1977), by shape: ends as the
/// sorted shapes only rise. M. Botsch and L. Kobbelt, "A remeshing approach to multiresolution
/// modeling" (2004), the third step, by valence: smoothing then makes the triangles round.
#pragma once

#include "mesh/remeshing/surface_replacement.h"

namespace tetfarm {

enum class FlipFor {
  shape,    ///< where the worse of the two triangles becomes better
  valence,  ///< where the numbers of triangles round the four vertices come nearer to 6, or to 3 in
            ///< the face of a curve's vertex, and no triangle becomes worse than passable_shape
};
inline constexpr double passable_shape = 0.6;

/// False: nothing has changed. Features are never flipped. Cost: 0.2 µs where it does not help,
/// else some 10 µs.
bool flip_edge(RemeshingWork& work, std::int32_t a, std::int32_t b, FlipFor wanted);

/// Flips until no flip helps, or each triangle has had some ten of them. The number of flips.
std::int64_t flip_edges(RemeshingWork& work, FlipFor wanted);

}  // namespace tetfarm
