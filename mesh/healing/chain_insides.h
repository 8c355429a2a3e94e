/// Which sides of a chain's triangles lie in what it winds round.
///
/// Source: A. Jacobson, L. Kavan and O. Sorkine-Hornung, "Robust inside-outside segmentation using
/// generalized winding numbers" (2013), of closed chains, where the numbers are whole and exact:
/// they change by what each triangle is there from one of its sides to the other. Lengths in the
/// unit of the input.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mesh/arrangement/chain_triangle.h"

namespace tetfarm {

/// For each triangle whether the winding number is 1 or more behind it, and in front of it. What is
/// thinner than the tolerance (its volume over half its border) is taken for the same as what it
/// has most of its border with. Nothing where the chain is not closed, or a part of it has no
/// vertex of its own. @pre no two triangles meet beyond common corners and edges. Cost: O(n log n),
/// and for each part the triangles along a ray.
std::optional<std::vector<std::array<bool, 2>>> insides_of(const TriangleChain& chain,
                                                           double tolerance);

}  // namespace tetfarm
