/// Medit/GMF: .mesh (text) and .meshb (binary, versions 1 to 4, either order of bytes).
#pragma once

#include <string>
#include <string_view>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// Triangles, and quadrangles as two triangles each, with their references as patches, "reference
/// N"; everything else is passed over.
/// @throws InvalidInput
SurfaceMesh read_medit(std::string_view bytes, const std::string& name);

}  // namespace tetfarm
