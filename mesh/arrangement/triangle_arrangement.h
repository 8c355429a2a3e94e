/// Divides triangles where they go through each other, until they meet in common corners and edges
/// alone.
///
/// Source: Q. Zhou, E. Grinspun, D. Zorin and A. Jacobson, "Mesh arrangements for solid geometry"
/// (2016): the triangles are divided exactly, those that overlap in one plane together; then the
/// new points are rounded to doubles, and what crosses after that is divided again. Where that does
/// not end, what is nearly the same is made one first (snap_to_neighbours). Lengths in the unit of
/// the input.
#pragma once

#include <optional>

#include "mesh/arrangement/chain_triangle.h"

namespace tetfarm {

/// What the triangles of a surface become: a chain with the same border, of which no two triangles
/// share any point but corners and edges that both have; triangles that meet none are the same, and
/// vertices keep their numbers. Triangles back to back are gone. Where exact division alone does
/// not do, what is within a thousandth of the tolerance is made one, then what is within the
/// tolerance. Nothing where that does not do either, or too much meets: as meeting_pairs says, or
/// more than a million pairs of segments, and 50 for each triangle, in the planes of triangles.
/// @pre vertices are finite. Deterministic. Cost: O(n log n) a round, at most 60 of them for each
/// distance, and a fraction of a millisecond for each pair.
std::optional<TriangleChain> arrange_triangles(const SurfaceMesh& surface, double tolerance);

}  // namespace tetfarm
