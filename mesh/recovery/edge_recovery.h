/// Recovers missing boundary edges by flips (thesis 4.3.3; kernel: boundary recovery, step 2).
///
/// What crosses the edge is removed: faces by 2-3 flips, else their edges, so that whatever is
/// removed leaves fewer crossings. Source: H. Si, "TetGen" (2015), section 3. Cost: as the
/// crossings, see edge_removal_by_flips.h.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/recovery/edge_removal_by_flips.h"
#include "mesh/recovery/local_remeshing.h"

namespace tetfarm {

/// One thing that the segment from a to b goes through: a face, or (face == no_face) an edge.
struct Crossing {
  FaceHandle face = no_face;
  std::array<std::int32_t, 2> edge = {-1, -1};
};

struct SegmentWalk {
  bool is_edge = false;             // ab is an edge of the complex
  std::int32_t node_on_it = -1;     // a node that lies on the segment, strictly between
  std::vector<Crossing> crossings;  // from a on, up to b or to the first edge that is crossed
};
/// Cost: O(star of a + crossings).
SegmentWalk walk_segment(const LocalRemeshing& mesh, std::int32_t a, std::int32_t b);

/// True when ab is an edge of the complex now. False: what was gained is kept.
bool recover_edge(LocalRemeshing& mesh, EdgeRemoval& removal, std::int32_t a, std::int32_t b,
                  int depth);

}  // namespace tetfarm
