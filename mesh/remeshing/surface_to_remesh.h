/// The input surface as the structure that remeshing changes.
#pragma once

#include "mesh/remeshing/changing_surface.h"
#include "mesh/remeshing/input_shape.h"
#include "mesh/remeshing/remeshing_spacing.h"

namespace tetfarm {

/// Vertices and triangles keep their numbers. @pre check_surface found no defect; `shape` is of
/// these. Cost: O(n log n).
ChangingSurface surface_to_remesh(const SurfaceMesh& surface, const SurfaceFeatures& features,
                                  const InputShape& shape, const RemeshingSpacing& spacing);

}  // namespace tetfarm
