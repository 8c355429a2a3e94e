/// Relaxes nodes so that the tets round them get rounder on average, once none is bad any more.
///
/// Source: thesis 4.3.4.1 (smoothing until edge lengths vary smoothly); the place aimed at is that
/// of L. Chen, "Mesh smoothing schemes based on optimal Delaunay triangulations" (2004): the mean
/// of the circumcentres of the ball, by volume.
#pragma once

#include <optional>

#include "mesh/cosmetics/smoothing.h"

namespace tetfarm::cosmetics {

/// A place where the sum of the radius ratios of the ball is larger and its worst goodness no
/// smaller. Cost: some five goodnesses a tet of the ball.
std::optional<Place> find_rounder_place(const WorkMesh& work, const std::vector<std::int32_t>& ball,
                                        std::int32_t node);

/// Relaxes each inner node that is set in `chosen` (a flag for each node), in order; the number of
/// moves.
std::int64_t relax_nodes(WorkMesh& work, const std::vector<bool>& chosen);

}  // namespace tetfarm::cosmetics
