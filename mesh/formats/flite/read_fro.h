/// FLITE .fro: the triangulated surface of the Swansea programs, text.
#pragma once

#include <string>
#include <string_view>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// The first line has the numbers of triangles and of nodes, then further counts that are passed
/// over; then a line "number x y z" for each node and "number a b c surface" for each triangle.
/// Exponents may be written with D. Patches are "surface N".
/// @throws InvalidInput
SurfaceMesh read_fro(std::string_view bytes, const std::string& name);

}  // namespace tetfarm
