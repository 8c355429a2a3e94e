/// Swaps faces for an edge: the 2-3 swap and its general form, multi-face removal.
///
/// Source: thesis 4.3.4.1 (face swapping); J. R. Shewchuk, "Two discrete optimization algorithms
/// for the topological improvement of tetrahedral meshes" (2002). A patch of faces that lie between
/// the same two apexes a and b is replaced by the edge ab and a tet over each edge of its rim: the
/// inverse of edge removal. The swaps 3-2 and 4-4 are in edge_removal.h.
#pragma once

#include <optional>

#include "mesh/cosmetics/cavity.h"

namespace tetfarm::cosmetics {

/// The best patch of faces to remove that holds the given face of tet t; nothing when the face is
/// on the boundary, or when the worst tet does not get better than both the present worst and
/// `beat`. Cost: at most some 50 qualities.
std::optional<Replacement> find_face_removal(const WorkMesh& work, std::int32_t t, int face,
                                             double beat);

}  // namespace tetfarm::cosmetics
