/// Triangles of a remeshed surface that lie farther from the input than they may.
///
/// Each change is compared with the input at the middles of its triangles and of some edges, at
/// half the tolerance (surface_replacement.h). That is as good as always enough; between those
/// points a large triangle over a tip can lie farther off. Divided across its longest edge, with
/// the new vertex on the input, it does not.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/remeshing/surface_replacement.h"

namespace tetfarm {

/// Those of which one of 25 points evenly spread, corners and points of feature edges apart, is
/// farther from the face's part of the input than its share of `tolerance`, in the order of their
/// numbers. Cost: O(n log n).
std::vector<std::int32_t> straying_triangles(const RemeshingWork& work, double tolerance);

/// Divides them, and what strays of the parts, four times at most. The number of splits. Cost: that
/// of as many searches.
std::int64_t split_straying_triangles(RemeshingWork& work, double tolerance);

}  // namespace tetfarm
