/// The faces of a part's tetrahedra: which two of them share one, and which have none.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/assemble/portion.h"

namespace tetfarm {

/// A face between two tets of a part. It may be a triangle between two regions, which the part then
/// has among its faces once for each.
struct InnerFace {
  std::int32_t owner = 0;      ///< the lower tet
  std::int32_t neighbour = 0;  ///< the higher one
  Triangle nodes{};            ///< local; the normal points out of the owner
};

/// A face that one tet of the part has.
struct OuterFace {
  std::int32_t owner = 0;
  std::int32_t face = -1;  ///< of part.faces; -1: it is on a cut
  Triangle nodes{};        ///< local; the normal points out of the owner
};

struct CellFaces {
  std::vector<InnerFace> inner;  ///< by owner, then neighbour
  std::vector<OuterFace> outer;  ///< by owner
};

/// @throws InvalidInput when a face has three tets, or a boundary triangle is no outer face.
/// Cost: O(n log n) in the tets that share their lowest node; about 40 bytes a face.
CellFaces cell_faces(const NumberedPart& part);

}  // namespace tetfarm
