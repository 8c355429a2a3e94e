/// Fields carried from one mesh to another with their integrals kept.
///
/// Source: F. Alauzet, M. Mehrenberger, "P1-conservative solution interpolation on unstructured
/// triangular meshes" (2010). On each new triangle K a linear function has the mean and the mean
/// gradient of the old field over the overlaps with old triangles, which are integrated exactly;
/// each new node takes the mean, by area, of these functions of the triangles round it. As the
/// integral of a field is the sum of (area / 3) × (values at the three nodes), that mean changes no
/// integral. Linear fields are exact, smooth ones second order, and a mesh onto itself changes
/// nothing.
/// Maximum principle: the function of K is brought within the least and the greatest value at the
/// nodes of the old triangles that K overlaps; what is cut off at one node is given to the others
/// in proportion to their room, so that the mean of K stays. It always fits, as the mean is within
/// the bounds.
/// Where K is not wholly covered by the old mesh, its function goes on over the rest, within the
/// same bounds; where K is not covered at all, nodes take the closest value. There integrals are
/// kept over what is covered only.
/// Cost: that of the overlaps (mesh_intersection.h), O(n) for meshes of alike triangles; some 30
/// flops more a pair and field.
#pragma once

#include <span>
#include <vector>

#include "mesh/adaptation/mesh_location.h"

namespace tetfarm {

struct ConservedFields {
  std::vector<std::vector<double>> fields;
  double covered_area = 0;  ///< of the target by the background
};

/// `fields`: each with a value for each node of the background. `places`: of the nodes of the
/// target (locate_nodes). Values and coordinates below 1e60 in size.
/// @throws InvalidInput as MeshIntersection.
ConservedFields transferred_conservatively(const MeshLocation& background,
                                           std::span<const std::vector<double>> fields,
                                           const TriangleComplex& target,
                                           std::span<const PlaneLocation> places);

/// The integral of a field that is linear in each triangle.
double field_integral(const TriangleComplex& complex, std::span<const double> values);

}  // namespace tetfarm
