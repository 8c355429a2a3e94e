/// Removes triangles of next to no height from a surface that is sound.
///
/// Source: M. Botsch and L. Kobbelt, "A robust procedure to eliminate degenerate faces from
/// triangle meshes" (2001): of a needle the short edge is drawn together, of a cap the longest edge
/// goes and its third vertex divides what lies beyond. Theirs cuts the mesh by planes first; here a
/// change is made only where an exact test finds nothing in its way. Lengths in the unit of the
/// input.
#pragma once

#include "mesh/healing/heal_act.h"

namespace tetfarm {

/// Triangles lower than the tolerance, and lower than this share of their longest edge, are nearly
/// flat: small ones of good shape are details, and stay.
inline constexpr double nearly_flat_share = 1e-4;

/// Removes those for which there is a way that moves no vertex that stays and makes nothing meet or
/// fold over; a longest edge goes only where what comes is higher. An edge is drawn together when
/// it is no longer than the tolerance. A shell that lies as a whole in what is moved over, less
/// than the tolerance thick, is not seen. The number that was removed. @pre no edge of the surface
/// is open, and no triangle is degenerate. Cost: O(n log n) for each of a few passes.
std::int64_t remove_nearly_flat_triangles(HealingWork& work);

}  // namespace tetfarm
