/// The duct of a jet engine, with an S-bend: long, narrow, and many wavelengths across, as problems
/// of waves inside ducts have it.
///
/// Source: thesis 5.2.1, fig. 114: "approximately a tube, of length 6.2 metres and diameter 0.45
/// metres". The thesis gives no sizes of its bend: here it is two arcs of 30 degrees one way and
/// back, in the middle, which move the tube sideways by 1.4 diameters. Metres.
#pragma once

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// A tube of diameter 0.45 whose centre line is 6.2 long: straight along x, an arc of radius 2.4
/// towards y, one back, and straight along x. Patches: "inlet", "wall", "outlet".
/// @throws UsageError when the spacing is not positive or far too small.
SurfaceMesh s_duct(double spacing);

}  // namespace tetfarm
