/// Wavefront OBJ: its vertices and polygons; texture, normals and smoothing are passed over.
#pragma once

#include <string>
#include <string_view>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// Polygons become triangles, as add_polygon makes them. Of the groups (g), objects (o) and
/// materials (usemtl), those become patches of which the file has most; g before o before usemtl
/// when equal. A face may use vertices above it only.
/// @throws InvalidInput
SurfaceMesh read_obj(std::string_view bytes, const std::string& name);

}  // namespace tetfarm
