/// Reads a surface by its file's ending, in any format of surfaces (surface_formats.h;
/// docs/file_formats.md), also as .gz.
#pragma once

#include <string>
#include <string_view>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// Vertices are welded only where bitwise equal (-0 and 0 are equal): all those of STL, of other
/// formats those on open edges. Solid names, OBJ groups and Gmsh physical groups become patches;
/// without any, one patch "surface".
/// @throws InvalidInput with "file:line" (or the byte of a binary file), IoError.
SurfaceMesh read_surface(const std::string& path);

/// As read_surface, from bytes already unpacked; `name` is used for its ending and in messages.
SurfaceMesh read_surface_bytes(std::string_view bytes, const std::string& name);

/// The file's bytes, unpacked when they are gzip.
std::string read_maybe_gzip(const std::string& path);

}  // namespace tetfarm
