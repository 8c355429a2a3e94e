/// The triangles that a part of a mesh shows: where its tets, or some of them, end.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/assemble/global_mesh.h"

namespace tetfarm {

/// A triangle to be drawn, with local node numbers of the part. A quad is two, cut at its lowest
/// node.
struct ShownFace {
  Triangle nodes;
  std::int32_t patch = -1;  ///< of the input surface; -1: inside of the domain
  std::int32_t region = 1;
  std::int64_t cell = -1;  ///< that it is of, as is_kept of outer_faces counts them; -1: not known
};

/// The triangles of the input surface that the part has, and the halves of its boundary quads.
std::vector<ShownFace> surface_faces(const NumberedPart& part);

/// The faces that exactly one of the cells has for which is_kept is true. Sorted by their nodes.
/// @pre is_kept has one entry for each tet, then for each cell in blocks. Cost: O(n log n).
std::vector<ShownFace> outer_faces(const NumberedPart& part, const std::vector<bool>& is_kept);

}  // namespace tetfarm
