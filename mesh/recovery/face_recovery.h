/// Recovers missing boundary faces whose edges are all there, by flips (kernel: boundary recovery,
/// step 3).
///
/// The edges that pierce the face are removed, with no new edge that pierces it.
/// Source: H. Si, "TetGen" (2015), section 3. Cost: as the piercing edges.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/recovery/edge_removal_by_flips.h"
#include "mesh/recovery/local_remeshing.h"

namespace tetfarm {

/// The edges of the complex that go through the inside of the face, each once, in the order found.
/// @pre the three edges of the face are edges of the complex.
std::vector<std::array<std::int32_t, 2>> piercing_edges(const LocalRemeshing& mesh,
                                                        const Triangle& face);

/// True when the face is in the complex now. False: what was gained is kept.
bool recover_face(LocalRemeshing& mesh, EdgeRemoval& removal, const Triangle& face, int depth);

}  // namespace tetfarm
