/// Judges a remeshed surface against its input, by code that shares nothing with mesh/remeshing.
///
/// Units: lengths in the unit of the input, degrees. For surfaces of some ten thousand triangles:
/// distances are found by looking at all of them.
#pragma once

#include <string>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

struct RemeshingDemands {
  double tolerance = 0;      ///< farthest that a point of one surface may be from the other
  double angle_deg = 30;     ///< edges whose normals differ by more are features
  double area_share = 0.02;  ///< by which the area of a patch may change
};

/// What is wrong with the result; empty: nothing. Looked at are numbers, closed edges, crossings,
/// shells and their Euler numbers, corners (where other than two features meet, or two turn by
/// more than the angle; not beside triangles flatter than a tenth of the tolerance, whose normals
/// say nothing), distances of vertices and middles of triangles both ways, names, volume, and the
/// area of each patch between each two regions. @pre check_surface finds no defect in the input.
/// Cost: O(n m) of triangles before and after.
std::vector<std::string> remeshing_complaints(const SurfaceMesh& input, const SurfaceMesh& result,
                                              const RemeshingDemands& demands);

}  // namespace tetfarm
