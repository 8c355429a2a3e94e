/// Puts a Steiner point on a boundary edge or face that flips could not recover, where something
/// crosses it.
///
/// What is crossed is split at the point, so that its parts are there at once when nothing else is
/// in the way; where there is no room for that, a tet that the edge or face runs through is split.
/// The point lies on the edge or face to some 100 bits, so that what was flat stays flat for all
/// that follows. Source: docs/kernel.md, "Boundary recovery", step 4. Cost: as the rings of the
/// crossed edges.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/recovery/edge_recovery.h"

namespace tetfarm {

/// The new node, at the middle one of the crossings, else at another one; -1 when there is no room.
/// `surface` may be older than the last points. @pre `walk` is walk_segment of the edge, with
/// crossings.
std::int32_t insert_on_edge(LocalRemeshing& mesh, const RecoverySurface& surface,
                            const std::array<std::int32_t, 2>& edge, const SegmentWalk& walk);

/// The new node, where the piercing edge nearest to the middle goes through; -1 when there is no
/// room.
std::int32_t insert_on_face(LocalRemeshing& mesh, const RecoverySurface& surface,
                            const Triangle& face);

}  // namespace tetfarm
