/// The nodes of a part as a file of the whole mesh has them: in runs of consecutive numbers.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/assemble/portion.h"

namespace tetfarm {

/// Visits each run once, ascending: the number of its first node, and the nodes. Those that
/// several parts share come with each of them, at the same places. Cost: O(n + r log r) for r runs.
void for_each_node_run(
    const NumberedPart& part,
    const std::function<void(std::int64_t first, const std::vector<Vec3>& nodes)>& visit);

}  // namespace tetfarm
