/// The inside of a round pipe with a bend: cuts across it are small, so it decomposes well.
#pragma once

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// A pipe of radius 1/2: straight for 1 along x, a quarter turn of radius 1 towards y, straight for
/// 1 along y. Patches: "inlet", "wall", "outlet".
/// @throws UsageError when the spacing is not positive or far too small.
SurfaceMesh bent_duct(double spacing);

}  // namespace tetfarm
