/// A trihedral corner reflector in a box: a body with a cavity whose three faces meet at right
/// angles, as radar targets have.
#pragma once

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// The cube [-1, 1]^3 without its octant of positive coordinates, in the box [-3, 3]^3. Patches:
/// "outer"; "reflector", the three faces of the cavity; "body", the rest of the cube.
/// @throws UsageError when the spacing is not positive or far too small.
SurfaceMesh corner_reflector(double spacing);

}  // namespace tetfarm
