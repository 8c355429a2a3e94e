/// How much higher the tets on top of the layers are than the last prisms below them: where the
/// heights go on evenly, solvers lose no accuracy there.
///
/// Source: DPW guidelines and AFLR3 blend the last layer into the isotropic spacing; the measure is
/// the height of the tet over its triangle of the top, divided by that of the prism.
#pragma once

#include <span>
#include <vector>

#include "mesh/core/tet_mesh.h"
#include "mesh/layers/top_heights.h"

namespace tetfarm {

/// The keys of the nodes of a part that are on the top and may be first in a triangle of it,
/// ascending. `origins` are those of its first nodes, or of all.
std::vector<std::uint64_t> firsts_of_top(std::span<const Origin> origins);

/// Of each tet that stands on one of the triangles, and for each that it stands on; in the order of
/// the tets. @pre `heights` are ascending. Cost: O(n log m) for n tets near the top, m heights.
std::vector<double> top_jumps(const TetMesh& mesh, std::span<const Origin> origins,
                              std::span<const TopHeight> heights);

}  // namespace tetfarm
