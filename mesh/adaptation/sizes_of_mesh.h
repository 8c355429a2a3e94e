/// The sizes that a mesh of the plane has, as metrics: for a background that is as fine as it.
///
/// Source: none in the thesis. Units: those of the mesh. Cost: O(edges).
#pragma once

#include <vector>

#include "mesh/metric/metric2.h"
#include "mesh/planar/triangle_complex.h"

namespace tetfarm {

/// At each point the isotropic metric of the mean length of its edges; of a point that no triangle
/// uses that of size 1.
std::vector<Metric2> sizes_of_mesh(const TriangleComplex& complex);

}  // namespace tetfarm
