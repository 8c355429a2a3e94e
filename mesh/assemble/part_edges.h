/// The edges of a part's cells.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/assemble/portion.h"

namespace tetfarm {

/// Each edge of the cells of any type once, the lower node first, in the order of its nodes, which
/// are local. Cost: O(n log n); memory of 8 bytes for each edge of each cell.
std::vector<std::array<std::int32_t, 2>> edges_of(const NumberedPart& part);

}  // namespace tetfarm
