/// Reads a .lb8.ugrid file of tets (write_ugrid.h has the format).
#pragma once

#include <filesystem>

#include "mesh/assemble/mesh_in_memory.h"

namespace tetfarm {

/// Boundary triangles may point either way, if all point the same way. @throws IoError,
/// InvalidInput (a wrong length, indices out of range, elements other than tets and triangles).
GlobalMesh read_ugrid(const std::filesystem::path& path);

}  // namespace tetfarm
