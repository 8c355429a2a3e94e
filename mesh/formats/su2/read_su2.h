/// SU2: the triangles of the markers of a mesh in three dimensions, or its elements when it has
/// none.
#pragma once

#include <string>
#include <string_view>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// Patches are the markers. Quadrangles become two triangles each; other elements are
/// refused in markers, passed over elsewhere.
/// @throws InvalidInput
SurfaceMesh read_su2(std::string_view bytes, const std::string& name);

}  // namespace tetfarm
