/// Reads an SU2 mesh in three dimensions (mesh/formats/su2/write_su2.h) piece by piece.
#pragma once

#include <filesystem>
#include <memory>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// As a parsed mesh (parsed_mesh.h). Markers are patches; the format has no regions. Normals of
/// boundary triangles point out of the domain. @throws IoError, InvalidInput with the line.
std::unique_ptr<MeshSource> open_su2(const std::filesystem::path& path,
                                     const std::filesystem::path& scratch_folder);

}  // namespace tetfarm
