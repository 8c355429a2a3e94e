/// Reads a .lb8.ugrid file (mesh/assemble/write_ugrid.h) piece by piece.
#pragma once

#include <filesystem>
#include <memory>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// The file does not know the sub-domains: a part is at most `tets_of_piece` consecutive tets of
/// one region. The file is mapped; in memory are the boundary triangles, sorted, and one part.
/// @throws IoError, InvalidInput.
std::unique_ptr<MeshSource> open_ugrid(const std::filesystem::path& path,
                                       std::int64_t tets_of_piece = 1'000'000);

}  // namespace tetfarm
