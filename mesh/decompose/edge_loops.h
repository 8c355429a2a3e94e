/// The loops: closed chains of surface edges between the two colours, the rim of the cut.
///
/// Source: thesis 4.3.1.5 to 4.3.1.7. A departure: read off the colours, so that they close and are
/// oriented by the triangles; no ray-line intersection is needed to tell inner from outer loops.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/decompose/face_colouring.h"

namespace tetfarm {

/// A directed surface edge with the cut on its left, seen from the right side (against the plane's
/// normal): as the left triangle uses it, reversed.
struct RimEdge {
  std::int32_t from = 0;
  std::int32_t to = 0;
  std::int32_t left_triangle = 0;
  std::int32_t right_triangle = 0;
};

struct EdgeLoops {
  /// Each loop in order of its path: edge i ends where edge i + 1 starts.
  std::vector<std::vector<RimEdge>> loops;
  /// Nodes that more than one loop, or one loop twice, passes: the loops are not singly connected.
  std::vector<std::int32_t> pinched_nodes;
};

/// Loops in the order of their first left triangle. With pinched nodes `loops` stays empty. Cost:
/// O(n).
EdgeLoops find_edge_loops(const FaceColours& colours, const SurfaceTopology& topology,
                          const std::vector<Triangle>& triangles);

}  // namespace tetfarm
