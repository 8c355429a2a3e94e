/// Moves a node so that the worst tet round it gets better.
///
/// Source: thesis 4.3.4.1 (the springs of Laplacian smoothing), tried first; where it fails, L. A.
/// Freitag, M. Jones and P. Plassmann, "A parallel algorithm for mesh smoothing" (1999): climb the
/// smallest quality along the shortest vector in the hull of the active gradients.
#pragma once

#include <optional>

#include "mesh/cosmetics/cavity.h"
#include "mesh/cosmetics/climbing.h"

namespace tetfarm::cosmetics {

/// The smallest quality of the star with its node at p; any value below `least` once it is below.
double worst_at(const Star& star, const Vec3& p, double least);

/// The star of a node in its ball.
Star star_of(const WorkMesh& work, const std::vector<std::int32_t>& ball, std::int32_t node);

/// Climbs from `start` (which may see faces from behind) until the worst quality is `enough`, or
/// no more progress is made.
/// Cost: at most some 60 qualities a face.
Place climb(const Star& star, const Vec3& start, double enough);

/// A better place for an inner node: the mean of its neighbours, or else by climbing; nothing when
/// the ball's worst does not get better by the margin.
std::optional<Place> find_move(const WorkMesh& work, const std::vector<std::int32_t>& ball,
                               std::int32_t node, double enough);

/// Moves the node unless a tet would not be exactly positive; false then.
bool move_node(WorkMesh& work, const std::vector<std::int32_t>& ball, std::int32_t node,
               const Vec3& to);

}  // namespace tetfarm::cosmetics
