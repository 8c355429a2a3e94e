/// What a decomposition will look like, from the work alone: which sub-domains, how large, before
/// any cut is made.
///
/// Source: thesis 4.3.1.4, the planes orthogonal to the axes only. The work samples of the root are
/// divided where a cut would be wanted; no surface is cut, so cuts that will turn out impossible,
/// or that go round obstacles, are not foreseen.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

struct PlannedSubdomain {
  TreePath path;
  std::int64_t parts = 1;  ///< leaves that it is to become; 1: it is one
  double elements = 0;     ///< estimated
  double triangles = 0;    ///< of its surface, with those of the cuts
};

/// How many leaves a sub-domain of so many elements and triangles is to become, when `parts` were
/// wanted of it.
using DecideParts =
    std::function<std::int64_t(double elements, double triangles, std::int64_t parts)>;

/// The tree, depth first, a node before its children, left before right. Every node has a leaf
/// below it for each of its parts, unless `decide` changes its mind.
/// Cost: O(s log s log(leaves)) for s work samples.
std::vector<PlannedSubdomain> plan_decomposition(const Subdomain& root, const SpacingField& spacing,
                                                 std::int64_t parts, const DecideParts& decide);

}  // namespace tetfarm
