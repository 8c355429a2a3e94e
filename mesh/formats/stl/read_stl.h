/// STL, binary and ASCII. Which of the two is decided by the size of the file, as many binary files
/// begin with the word "solid".
#pragma once

#include <string>
#include <string_view>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// Vertices are welded where bitwise equal (-0 equals 0). Each `solid NAME` of an ASCII file is a
/// patch. Normals and the attribute bytes are not read: the order of the vertices gives the
/// orientation.
/// @throws InvalidInput
SurfaceMesh read_stl(std::string_view bytes, const std::string& name);

}  // namespace tetfarm
