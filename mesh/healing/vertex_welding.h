/// Joins vertices of a surface that were meant to be one.
///
/// Source: G. Butlin and C. Stops, "CAD data repair" (1996): gaps below a tolerance are closed by
/// joining what is on both sides.
#pragma once

#include "mesh/healing/heal_act.h"

namespace tetfarm {

/// Joins vertices on open edges, and the ends of edges of defective triangles, that lie within the
/// tolerance of each other, into the one of the lowest number; triangles that lose a side go.
/// Sheets near each other whose edges are closed are left alone.
/// @param is_bad of each triangle: whether it is part of a defect. The number of vertices that
/// went. Cost: O(n log n).
std::int64_t weld_vertices(HealingWork& work, const std::vector<char>& is_bad);

}  // namespace tetfarm
