/// Puts a Steiner point on a boundary edge or face that flips could not recover, where something
/// crosses it.
///
/// What is crossed is split at the point, so that its parts are there at once when nothing else is
/// in the way; where rounding forbids that, a constrained cavity takes the point in. Source: kernel
/// notes, boundary recovery, step 4. Cost: as the ring of the crossed edge.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/volume/edge_recovery.h"

namespace tetfarm {

/// The new node, at the middle one of the crossings, else at another one; -1 when there is no room.
/// @pre `walk` is walk_segment of the edge, with crossings.
std::int32_t insert_on_edge(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                            const std::array<std::int32_t, 2>& edge, const SegmentWalk& walk);

/// The new node, near where the middle one of the piercing edges goes through; -1 when there is no
/// room.
std::int32_t insert_on_face(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                            const Triangle& face);

}  // namespace tetfarm
