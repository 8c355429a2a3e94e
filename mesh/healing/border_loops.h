/// The loops of open edges of some triangles.
///
/// Source: none; each open edge leads from one vertex to the next, against the direction in which
/// its triangle has it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/inspect/surface_edges.h"

namespace tetfarm {

struct BorderLoop {
  std::vector<std::int32_t> vertices;  ///< each once; a triangle in it has them in this order
  std::int32_t triangle = 0;           ///< the one on its first edge
};

/// Of edges with one use; loops through a vertex where several begin are left out, as are chains
/// that do not close. In the order of their lowest edges. Cost: O(n log n).
std::vector<BorderLoop> border_loops(std::span<const EdgeUse> uses);

}  // namespace tetfarm
