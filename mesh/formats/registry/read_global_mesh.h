/// Reads a finished mesh into memory as a whole. Who can take it a part at a time opens it as a
/// MeshSource (mesh/formats/registry/open_mesh.h).
#pragma once

#include <filesystem>
#include <string_view>

#include "mesh/assemble/mesh_in_memory.h"

namespace tetfarm {

/// Reads .vtkhdf or .lb8.ugrid by the ending. @throws IoError, InvalidInput (another ending, a file
/// that is no mesh of tets).
GlobalMesh read_global_mesh(const std::filesystem::path& path);
/// The same of a file that is kept under another name than `name`, which tells the format.
GlobalMesh read_global_mesh(const std::filesystem::path& path, std::string_view name);

}  // namespace tetfarm
