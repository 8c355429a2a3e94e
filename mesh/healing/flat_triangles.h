/// Removes triangles without area.
///
/// Source: M. Botsch and L. Kobbelt, "A robust procedure to eliminate degenerate faces from
/// triangle meshes" (2001), their caps: the corner that lies on the opposite side divides it.
#pragma once

#include "mesh/healing/heal_act.h"

namespace tetfarm {

/// A triangle whose three vertices lie on a line goes, and those beyond its longest side are
/// divided where its third vertex is. @pre no triangle has a vertex twice. The number that went.
/// Cost: O(n log n) for each of a few passes.
std::int64_t remove_flat_triangles(HealingWork& work);

}  // namespace tetfarm
