/// Finds the tet that holds a point, by a walk from tet to tet.
///
/// Source: O. Devillers, S. Pion, M. Teillaud, "Walking in a triangulation" (2002): the visibility
/// walk, with the first face tried turned at every step. Cost: O(1) when the start is near.
#pragma once

#include <cstdint>

#include "mesh/core/tet_complex.h"

namespace tetfarm {

/// Where a point lies: in a tet (its closure), or on a node of it exactly.
struct Location {
  std::int32_t tet = -1;
  std::int32_t node = -1;
};

/// Walks from `start` (any live tet), through whatever faces. tet == -1 when the point lies outside
/// the complex.
Location locate(const TetComplex& complex, const Vec3& point, std::int32_t start);

}  // namespace tetfarm
