/// Reads a binary Medit/GMF mesh of any version (mesh/formats/medit/write_meshb.h), piece
/// by piece.
#pragma once

#include <filesystem>
#include <memory>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// As a listed mesh (listed_mesh.h), without the scratch folder. References of faces are patches,
/// of cells regions, from 1.
/// @throws IoError, InvalidInput with the byte.
std::unique_ptr<MeshSource> open_meshb(const std::filesystem::path& path,
                                       const std::filesystem::path& scratch_folder);

}  // namespace tetfarm
