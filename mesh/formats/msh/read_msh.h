/// Gmsh .msh, versions 2.2 and 4.1, ASCII and binary (little endian): the triangles of the surface
/// with their physical groups.
#pragma once

#include <string>
#include <string_view>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// Points, lines and volume elements are passed over, and so are nodes that no triangle uses.
/// Quadrangles become two triangles each; elements of higher order throw. A triangle's patch is its
/// first physical group.
/// @throws InvalidInput
SurfaceMesh read_msh(std::string_view bytes, const std::string& name);

}  // namespace tetfarm
