/// TetGen: .poly and .smesh, facets over a list of nodes.
#pragma once

#include <string>
#include <string_view>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// Nodes must be in the file itself. Polygons become triangles, as add_polygon makes them; a
/// facet with holes or loose edges is refused. Boundary marks are the patches, "mark N"; points in
/// holes and regions are passed over.
/// @throws InvalidInput
SurfaceMesh read_tetgen(std::string_view bytes, const std::string& name);

}  // namespace tetfarm
