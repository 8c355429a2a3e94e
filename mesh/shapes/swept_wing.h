/// A swept half wing at a symmetry plane in a far field, as flow solvers are fed: the edge length
/// grows a hundredfold from the wing outward.
#pragma once

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// NACA 0012, root chord 1 about the origin, tip chord 1/2, half span 1.2 along y, leading edge
/// swept by 30 degrees, flat tip; in the half ball y >= 0 of radius 10. The edge length is
/// `spacing` on the wing and grows by `growth` per unit of length over the symmetry plane. Patches:
/// "symmetry", "wing", "far field".
/// @throws UsageError when spacing or growth is not positive or far too small.
SurfaceMesh swept_wing(double spacing, double growth);

}  // namespace tetfarm
