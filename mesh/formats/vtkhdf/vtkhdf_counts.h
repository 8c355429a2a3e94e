/// How much the partitions of a VTKHDF file have, and how much comes before each.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/assemble/portion.h"

namespace tetfarm {

/// What a partition has. Its cells lie in the arrays as tets, pyramids, prisms, hexes, then
/// triangles and quads of the boundary.
struct VtkhdfCounts {
  std::int64_t points = 0;
  std::int64_t tets = 0;
  std::int64_t faces = 0;
  ElementCounts others{};  ///< of the types in blocks

  friend bool operator==(const VtkhdfCounts&, const VtkhdfCounts&) = default;
};
VtkhdfCounts vtkhdf_counts(const NumberedPart& part);

std::int64_t cells_of(const VtkhdfCounts& part);
/// Nodes of all its cells and boundary faces, a node as often as it occurs.
std::int64_t ids_of(const VtkhdfCounts& part);

/// How much of the arrays comes before a partition.
struct VtkhdfBefore {
  std::int64_t points = 0;
  std::int64_t cells = 0;
  std::int64_t ids = 0;
};

/// For each partition, and behind the last.
std::vector<VtkhdfBefore> before_each(std::span<const VtkhdfCounts> parts);

}  // namespace tetfarm
