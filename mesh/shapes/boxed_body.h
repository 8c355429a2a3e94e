/// A body in a box that fits it, for waves that need only a few of their lengths of room round it:
/// the cube of mesh/inspect/outer_boundary.h would have many times the volume of a flat body.
///
/// Source: thesis 5.2.2, fig. 120: the box round the Dassault Falcon.
#pragma once

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

struct FittingBox {
  double margin = 0;   ///< between the body's bounding box and the box, on each side
  double spacing = 0;  ///< side of the box's squares, each of which is two triangles
};

/// The body's triangles turned over, then the box's, as a new patch "outer". Where the body has no
/// patches its own become "surface". What regions the body bounds is forgotten.
/// @pre the body is oriented outward.
/// @throws UsageError when a number is not positive, the spacing is far too small, the body has no
/// triangles, or has a patch "outer". Cost: O(n log n).
SurfaceMesh boxed_body(const SurfaceMesh& body, const FittingBox& box);

}  // namespace tetfarm
