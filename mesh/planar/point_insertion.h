/// Points inside the region, placed by the spacing from the boundary inward.
///
/// Source: S. Rebay, "Efficient unstructured mesh generation by means of Delaunay triangulation and
/// Bowyer-Watson algorithm" (1993): advancing-front placing in a Delaunay triangulation, which
/// joins the two ways that thesis 2.2 compares and 4.3.1.9 chose for the cuts. Departure from the
/// thesis's [18]: candidates stand at the apex of a front edge, not at centroids.
#pragma once

#include <cstdint>

#include "mesh/planar/planar_mesh.h"
#include "mesh/planar/triangle_complex.h"

namespace tetfarm {

/// Inserts points until every triangle is of the spacing's size or has no room for one; the
/// triangulation stays constrained Delaunay. False when it would take more than `max_triangles`.
/// @pre `complex` is constrained Delaunay; spacing is positive.
/// Cost: O(1) a point, about one call of `spacing` a triangle.
bool insert_points(TriangleComplex& complex, const PlanarSpacing& spacing,
                   std::int64_t max_triangles);

/// Roughly how many triangles the spacing asks for, from samples.
/// Cost: one call of `spacing` a triangle, and some ten thousand.
double estimated_triangles(const TriangleComplex& complex, const PlanarSpacing& spacing);

}  // namespace tetfarm
