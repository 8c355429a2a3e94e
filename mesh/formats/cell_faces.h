/// The faces of a part's cells: which two of them share one, and which have none. Cells and
/// boundary faces are counted as in part_cells.h.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/assemble/portion.h"
#include "mesh/core/face_nodes.h"

namespace tetfarm {

/// A face between two cells of a part. It may be a face between two regions, which the part then
/// has among its boundary faces once for each.
struct InnerFace {
  std::int32_t owner = 0;         ///< the lower cell
  std::int32_t neighbour = 0;     ///< the higher one
  FaceNodes<std::int32_t> nodes;  ///< local; the normal points out of the owner
};

/// A face that one cell of the part has.
struct OuterFace {
  std::int32_t owner = 0;
  std::int32_t face = -1;         ///< of the boundary faces; -1: it is on a cut
  FaceNodes<std::int32_t> nodes;  ///< local; the normal points out of the owner
};

struct CellFaces {
  std::vector<InnerFace> inner;  ///< by owner, then neighbour
  std::vector<OuterFace> outer;  ///< by owner
};

/// A quad is shared by cells that both have it as a quad.
/// @throws InvalidInput when a face has three cells, or a boundary face is no outer face.
/// Cost: O(n log n) in the cells that share their lowest node; about 50 bytes a face.
CellFaces cell_faces(const NumberedPart& part);

}  // namespace tetfarm
