/// A ball as a hole in a larger ball or in a box: even surfaces at every spacing.
#pragma once

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// The space between spheres of radius 1 ("inner") and 2 ("outer") about the origin.
/// @throws UsageError when the spacing is not positive or far too small.
SurfaceMesh sphere_in_sphere(double spacing);

/// The space between a sphere of radius 1 ("inner") and the box [-2, 2]^3 ("outer").
/// @throws as sphere_in_sphere.
SurfaceMesh sphere_in_box(double spacing);

}  // namespace tetfarm
