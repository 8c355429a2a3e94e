/// Writes a surface as text by its file's ending: .off, or .stl with a solid for each patch.
///
/// 17 digits: read_surface gives the same coordinates back. OFF knows no patches.
#pragma once

#include <string>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

std::string write_off(const SurfaceMesh& surface);
std::string write_stl(const SurfaceMesh& surface);

/// @throws UsageError for another ending, IoError. The file is wholly there or not at all.
void write_surface(const SurfaceMesh& surface, const std::string& path);

}  // namespace tetfarm
