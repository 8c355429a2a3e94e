/// Moves inner nodes so that the triangles round them get better; the connections stay.
///
/// Source: thesis 4.3.4.1 (smoothing in mesh cosmetics), here in the plane. Worst-angle guard: L.
/// A. Freitag and C. Ollivier-Gooch, "Tetrahedral mesh improvement using swapping and smoothing"
/// (1997).
#pragma once

#include <cstdint>

#include "mesh/planar/planar_mesh.h"
#include "mesh/planar/triangle_complex.h"

namespace tetfarm {

/// One sweep over the nodes from `first_free` on, in order: each goes towards the mean of its
/// neighbours when the worst triangle round it does not get worse by that and all stay exactly
/// anticlockwise. Returns the number of nodes moved.
/// @pre every node from first_free on is inside: all triangles round it are there.
/// Cost: O(n).
std::size_t smooth(TriangleComplex& complex, std::int32_t first_free);

/// Shape of a triangle: 1 for the regular one, 0 for a flat, negative for a clockwise one
/// (4 sqrt(3) area / sum of squared edges).
double triangle_quality(const Vec2& a, const Vec2& b, const Vec2& c);

}  // namespace tetfarm
