/// Reads the VTK XML files of a mesh of tets (mesh/formats/pvtu/write_pvtu.h) piece by piece: a
/// .pvtu with its .vtu files, or a single .vtu.
#pragma once

#include <filesystem>
#include <memory>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// Pieces are sub-domains. Arrays are appended, raw, little endian, with lengths of 64 bits, of the
/// types that write_pvtu gives them. A .vtu alone needs no GlobalNodeId.
/// Read in place, without the scratch folder.
/// @throws IoError, InvalidInput with file and line or byte.
std::unique_ptr<MeshSource> open_pvtu(const std::filesystem::path& path,
                                      const std::filesystem::path& scratch_folder);

}  // namespace tetfarm
