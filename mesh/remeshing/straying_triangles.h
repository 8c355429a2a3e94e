/// Triangles of a remeshed surface that lie farther from the input than they may.
///
/// Each change is compared with the input at the middles of its triangles and of some edges, at
/// half the tolerance (surface_replacement.h). That is as good as always enough; between those
/// points a large triangle over a tip can lie farther off.
#pragma once

#include <cstdint>

#include "mesh/remeshing/surface_replacement.h"

namespace tetfarm {

/// The number of triangles of which one of 25 points evenly spread, corners and those of
/// feature edges apart, is farther from the face's part of the input than its share of `tolerance`.
/// Cost: O(n log n).
std::int64_t straying_triangles(const RemeshingWork& work, double tolerance);

}  // namespace tetfarm
