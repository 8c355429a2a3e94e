/// Reads a Gmsh mesh piece by piece: MSH 4.1 and 2.2, text and little-endian binary
/// (mesh/formats/msh/write_msh41.h, write_msh22.h).
#pragma once

#include <filesystem>
#include <memory>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// As a parsed mesh (parsed_mesh.h). Nodes have the numbers 1 to N, in any order. A face's
/// patch and a cell's region are its first physical group, by its number; without one, 1. Volume
/// entities of 4.1 are sub-domains, in 2.2 partitions are, where cells have them. Points and lines
/// are passed over. @throws IoError, InvalidInput with the line or byte.
std::unique_ptr<MeshSource> open_msh(const std::filesystem::path& path,
                                     const std::filesystem::path& scratch_folder);

}  // namespace tetfarm
