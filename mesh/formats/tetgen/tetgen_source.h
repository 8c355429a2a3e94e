/// Reads TetGen's .node, .face and .ele of a mesh (mesh/formats/tetgen/write_tetgen.h) piece by
/// piece.
#pragma once

#include <filesystem>
#include <memory>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// `path` is one of the three; the others lie beside it. As a parsed mesh (parsed_mesh.h). Numbers
/// begin with that of the first node, 0 or 1. Marks of faces are patches, the attribute of a tet
/// its region, from 1. @throws IoError, InvalidInput with file and line.
std::unique_ptr<MeshSource> open_tetgen(const std::filesystem::path& path,
                                        const std::filesystem::path& scratch_folder);

}  // namespace tetfarm
