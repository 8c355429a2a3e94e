/// Relaxes nodes so that the tets round them get rounder on average, once few are bad any more.
///
/// Source: thesis 4.3.4.1 (smoothing until edge lengths vary smoothly). What falls is the sum over
/// the ball of (sum of the squared edges)³ / volume², the inverse of the mean ratio, by one step of
/// Newton: T. Munson, "Mesh shape-quality optimization using the inverse mean-ratio metric" (2007).
/// The term of a tet grows without bound as it flattens, and the step needs + − × ÷ only.
#pragma once

#include <optional>
#include <vector>

#include "mesh/cosmetics/cavity.h"

namespace tetfarm::cosmetics {

/// A place where that sum is smaller by more than a thousandth, and each quality of the ball at
/// least `floor`, or the smallest that was there.
/// Cost: some four qualities a tet of the ball.
std::optional<Vec3> find_rounder_place(const WorkMesh& work, const std::vector<std::int32_t>& ball,
                                       std::int32_t node, double floor);

/// Relaxes each inner node that is set in `chosen` (a flag for each node), in order; the number of
/// moves.
std::int64_t relax_nodes(WorkMesh& work, const std::vector<bool>& chosen, double floor);

}  // namespace tetfarm::cosmetics
