/// Triangles in place of the polygons of surface files, which modelling programs write with any
/// number of corners: convex or not, with corners on straight sides.
///
/// Source: ear clipping, G. H. Meisters, "Polygons have ears" (1975), after a fan round the first
/// corner was tried. A polygon that is not flat is seen along the axis that its normal (Newell's)
/// is nearest to. Orientation is exact.
#pragma once

#include <cstdint>
#include <span>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// Adds the triangles to the surface, and says how many: the fan round the first corner where all
/// of its triangles turn the polygon's way, which holds of those that are convex without corners on
/// straight sides; else triangles between the corners, none of them flat. Corners at the same place
/// may be there twice, as on the cut to a hole. Of a polygon that crosses itself, or has no area,
/// what cannot be cut in this way becomes a fan, for the check of the surface to judge.
/// @pre at least 3 corners, each a vertex of the surface. Cost: O(corners) for a fan, else
/// O(corners²), and not more than 2^26 corners looked at.
std::size_t add_polygon(SurfaceMesh& surface, std::span<const std::int32_t> corners);

}  // namespace tetfarm
