/// What the surface itself asks for: at each vertex the mean length of its edges.
///
/// Departs from the thesis, which has sources only. The mean over the edges of a vertex, not the
/// square root of a triangle's area or the shortest edge: a needle (CAD tessellations, sharp
/// trailing edges) then asks for about two thirds of its length, and does not flood the inside with
/// its thickness.
#pragma once

#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// A demand at a point: `spacing` within `plateau` of it, growing beyond.
struct PointDemand {
  Vec3 at;
  double spacing = 0;
  double plateau = 0;
};

/// The plateau in edge lengths. The field is interpolated between octree corners that lie about
/// half a cell off the surface; without a plateau it would come out 15-25 % too large on the
/// surface.
inline constexpr double surface_plateau = 0.6;

/// One demand for each vertex that a triangle with an edge of positive length uses, in vertex
/// order. Cost: O(triangles).
std::vector<PointDemand> surface_spacing(const SurfaceMesh& surface);

}  // namespace tetfarm
