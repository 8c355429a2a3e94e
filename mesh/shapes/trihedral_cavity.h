/// A trihedral cavity in a box: a corner of three plates at right angles that sends waves back to
/// where they came from, as simulations of scattering are compared on.
///
/// Source: thesis 5.2.3, fig. 124. The thesis gives no sizes: here the box has the volume that the
/// thesis's elements fill at ten nodes a wavelength of 20 GHz, and the cavity is 24 wavelengths
/// deep along its edges. Metres.
#pragma once

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// The cavity's faces are right-angled triangles with legs of 0.36 from the origin along x, y and
/// z; its plates are 0.03 thick and end at the plane of its mouth, x + y + z = 0.36. The box is
/// [-0.15, 0.54]^3. Patches: "outer"; "cavity", its three faces; "body", the rest of the plates.
/// @throws UsageError when the spacing is not positive or far too small. Cost: O(n log n).
SurfaceMesh trihedral_cavity(double spacing);

}  // namespace tetfarm
