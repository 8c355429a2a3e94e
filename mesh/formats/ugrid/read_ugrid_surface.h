/// AFLR3/NASA UGRID: the boundary triangles of a surface or volume mesh, with their patch numbers.
#pragma once

#include <string>
#include <string_view>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// What stands before .ugrid tells the form: nothing is text; b8, lb8, b8l, lb8l, b4, lb4 are
/// binary, big or little endian, with 64-bit integers (l), coordinates of 8 or 4 bytes. Volume
/// elements are passed over; quadrangles become two triangles each. A triangle's patch is "patch
/// N".
/// @throws InvalidInput
SurfaceMesh read_ugrid_surface(std::string_view bytes, const std::string& name);

}  // namespace tetfarm
