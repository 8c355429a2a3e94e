/// Divides the graph of the leaves into groups of about equal work with few shared triangles
/// between them, by METIS.
///
/// Source: thesis 4.3.2.1 and fig. 69: METIS_PartGraphRecursive, METIS_PartGraphKway by the edge
/// cut, and by the volume of communication.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/assimilation/subdomain_graph.h"

namespace tetfarm {

enum class PartitionMethod { recursive, k_way, k_way_volume };

/// The group of each leaf, 0 ... groups - 1. Groups may come out empty or in several pieces: see
/// group_refinement.h. @pre 1 <= groups. @throws std::bad_alloc.
/// Cost: O(leaves + edges), times log(groups) for recursive. Not safe with other users of rand().
std::vector<std::int32_t> partition_graph(const SubdomainGraph& graph, std::int32_t groups,
                                          PartitionMethod method);

}  // namespace tetfarm
