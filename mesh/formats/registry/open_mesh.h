/// Opens a finished mesh in one of the formats that the list of formats reads.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "base/file_system.h"
#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// The ending tells the format; a folder is a case of OpenFOAM. Text formats are read once and kept
/// in files without names in `scratch_folder` (parsed_mesh.h). @throws IoError, InvalidInput with
/// file and line or byte.
std::unique_ptr<MeshSource> open_mesh(
    const std::filesystem::path& path,
    const std::filesystem::path& scratch_folder = temporary_folder());
/// The same of a file that is kept under another name than `name`, which tells the format.
std::unique_ptr<MeshSource> open_mesh_as(
    const std::filesystem::path& path, std::string_view name,
    const std::filesystem::path& scratch_folder = temporary_folder());

/// Whether a folder is a mesh of some format, such as a case of OpenFOAM.
bool is_mesh_folder(const std::filesystem::path& folder);

/// The endings and the kinds of folders, for messages: ".vtkhdf, .lb8.ugrid, …, OpenFOAM cases".
std::string readable_meshes();

}  // namespace tetfarm
