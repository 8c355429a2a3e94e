/// Second derivatives of a field at the nodes of a mesh.
///
/// Source: thesis 3.3.1, equations 11 to 13, is `double_projection`: the gradient of each triangle,
/// averaged over the ball of a node, twice over. It is wrong at the boundary, where the default is
/// not: the quadratic that fits the two rings round a node best (weighted least squares through the
/// node's own value), exact for a quadratic field on any mesh.
/// Cost: O(nodes), some microseconds each.
#pragma once

#include <span>
#include <vector>

#include "mesh/metric/metric2.h"
#include "mesh/planar/triangle_complex.h"

namespace tetfarm {

enum class HessianRecovery { quadratic_fit, double_projection };

/// [uxx uxy; uxy uyy] at each node; of a node that no triangle uses 0. `values`: one a node.
std::vector<Metric2> recover_hessians(const TriangleComplex& complex,
                                      std::span<const double> values, HessianRecovery recovery);

}  // namespace tetfarm
