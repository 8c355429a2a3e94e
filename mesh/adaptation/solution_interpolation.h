/// Fields at places of a mesh, linear in each triangle.
///
/// Source: thesis 3.3.3, end: the solution is interpolated to the new mesh. Exact for linear
/// fields, second order for smooth ones; no value leaves those of the three nodes round it. What
/// lies between the places is not seen: integrals change, a little each time
/// (conservative_transfer.h keeps them).
/// Cost: O(places) for each field.
#pragma once

#include <span>
#include <vector>

#include "mesh/adaptation/mesh_location.h"

namespace tetfarm {

/// `values`: one for each node of the background, on which the places lie.
std::vector<double> interpolated(const TriangleComplex& background, std::span<const double> values,
                                 std::span<const PlaneLocation> places);

}  // namespace tetfarm
