/// Triangles between exact points of one plane that have given edges.
///
/// Source: points are inserted one by one; S. W. Sloan, "A fast algorithm for generating
/// constrained Delaunay triangulations" (1993): edges that cross a given one are flipped until none
/// does. What shape triangles have is judged in doubles, what is left of what exactly: the result
/// is a triangulation in any case, and Delaunay up to rounding.
#pragma once

#include <optional>
#include <vector>

#include "mesh/arrangement/segment_division.h"
#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// Triangles that fill all that the edges enclose, and some of what is between, anticlockwise as
/// seen along the axis, in the numbers of the points. @pre `nodes` are different points of a plane
/// which is not seen edge-on; `edges` join some of them, and meet each other and nodes only at
/// ends. Deterministic. Cost: about O(n^1.5), O(n^2) at worst, and for each edge what it crosses.
std::optional<std::vector<Triangle>> triangulate(const ExactPoints& points,
                                                 const std::vector<std::int32_t>& nodes,
                                                 const std::vector<Segment>& edges, int axis);

}  // namespace tetfarm
