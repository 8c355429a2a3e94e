/// Closed surfaces whose domains fill little of their box: the lattice round them is mostly
/// outside. For tests of what filling them costs.
#pragma once

#include "mesh/core/surface_mesh.h"

namespace tetfarm::shapes {

/// A lens over a swept parallelogram, chord 1 and span 4 with the given thickness in its middle;
/// n edges along the chord, 4 n along the span.
SurfaceMesh thin_wing(double thickness, int n);

/// A tube round a helix of so many turns: radius 1, rise 0.5 a turn, tube of radius 0.05; n edges
/// round the tube.
SurfaceMesh spiral(int turns, int n);

/// A sphere of radius 1 within one that is larger by the thickness (levels each).
SurfaceMesh thin_shell(double thickness, int levels);

/// n^3 icospheres of 80 triangles and radius 0.1 at distances of 1, none in line with another.
SurfaceMesh scattered_bodies(int n);

/// What lies round the bodies in a box that is `factor` times as large as theirs; n squares a side.
SurfaceMesh in_large_box(const SurfaceMesh& bodies, double factor, int n);

}  // namespace tetfarm::shapes
