/// OFF, the Object File Format (ASCII): a count of vertices and faces, then both.
#pragma once

#include <string>
#include <string_view>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// Also COFF, NOFF and CNOFF: what follows the coordinates or the vertices of a face on its line, a
/// colour or a normal, is passed over. Polygons become triangles, as add_polygon
/// makes them.
/// @throws InvalidInput
SurfaceMesh read_off(std::string_view bytes, const std::string& name);

}  // namespace tetfarm
