/// Writes a surface as OFF, which knows no patches.
#pragma once

#include <string>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// With all digits: read_off gives the same coordinates back.
std::string write_off(const SurfaceMesh& surface);

}  // namespace tetfarm
