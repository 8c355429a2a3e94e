/// Closes seams whose two sides have different vertices.
///
/// Source: G. Barequet and S. Kumar, "Repairing CAD models" (1997): an edge with a vertex of the
/// other side on it is divided there.
#pragma once

#include "mesh/healing/heal_act.h"

namespace tetfarm {

/// Divides the triangles of open edges at the vertices of other open edges that lie on them, within
/// the tolerance. The number of edges divided. Cost: O(n log n).
std::int64_t divide_open_edges(HealingWork& work);

}  // namespace tetfarm
