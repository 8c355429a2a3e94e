/// Swaps edges: until no ellipse through a triangle holds the node beyond its edge, or while the
/// worse of the two triangles beside one becomes better.
///
/// Source: thesis 4.3.1.10 (edge swapping) in the metric. By ellipses, with the mean metric of the
/// four nodes, a mesh leaves states that the other criterion cannot leave, but need not end where
/// metrics vary: the number of swaps that one edge brings about is bounded. By energy the sorted
/// energies of the mesh only fall, so that it ends. Cost: O(edges + swaps).
#pragma once

#include <cstdint>

#include "mesh/adaptation/metric_mesh.h"

namespace tetfarm {

/// Bits of MetricMesh::unchecked.
enum class SwapCriterion : std::uint8_t { ellipse = 1, energy = 2 };

/// Of unchecked triangles alone, where asked for; afterwards all are checked by this criterion.
/// Returns how many edges were swapped.
std::int64_t swap_edges(MetricMesh& mesh, SwapCriterion criterion, bool only_unchecked);

}  // namespace tetfarm
