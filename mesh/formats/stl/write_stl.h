/// Writes a surface as ASCII STL, a solid for each patch.
#pragma once

#include <string>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// With all digits: read_stl gives the same coordinates back.
std::string write_stl(const SurfaceMesh& surface);

}  // namespace tetfarm
