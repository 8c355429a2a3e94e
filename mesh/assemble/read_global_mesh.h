/// Reads a finished mesh into memory as a whole. Who can take it a part at a time opens it as a
/// MeshSource (mesh/formats/open_mesh.h).
#pragma once

#include <filesystem>

#include "mesh/assemble/mesh_in_memory.h"

namespace tetfarm {

/// Reads .vtkhdf or .lb8.ugrid by the ending. @throws IoError, InvalidInput (another ending, a file
/// that is no mesh of tets).
GlobalMesh read_global_mesh(const std::filesystem::path& path);

}  // namespace tetfarm
