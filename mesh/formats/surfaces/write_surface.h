/// Writes a surface by its file's ending, in the formats of surfaces that are written
/// (surface_formats.h).
#pragma once

#include <string>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// @throws UsageError for another ending, IoError. The file is wholly there or not at all.
void write_surface(const SurfaceMesh& surface, const std::string& path);

}  // namespace tetfarm
