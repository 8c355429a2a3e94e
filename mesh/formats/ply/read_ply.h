/// PLY, the Polygon File Format: ASCII, binary of either order of bytes.
#pragma once

#include <string>
#include <string_view>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// Any further elements and properties are passed over, whatever their values. Polygons become
/// triangles, as add_polygon makes them, and so do strips of triangles (tristrips); there are no
/// patches.
/// @throws InvalidInput
SurfaceMesh read_ply(std::string_view bytes, const std::string& name);

}  // namespace tetfarm
