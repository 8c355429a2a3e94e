/// Meshes of the plane and fields at their nodes as binary Medit files (.meshb, .solb): read in GMF
/// versions 1 to 4 and either order of bytes, written in version 3, whose integers have 32 bits and
/// places in the file 64.
///
/// Source: libMeshb's documentation, "GMF file format". What the lists hold is as in the text files
/// (plane_medit.h).
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "mesh/formats/plane/plane_medit.h"

namespace tetfarm {

/// @throws InvalidInput with the byte.
PlaneMesh read_plane_meshb(std::string_view bytes, const std::string& name);
/// @throws IoError.
void write_plane_meshb(const PlaneMesh& mesh, const std::filesystem::path& path);

/// @throws InvalidInput with the byte.
NodeFields read_plane_solb(std::string_view bytes, const std::string& name);
/// @throws IoError.
void write_plane_solb(std::span<const Metric2> metrics, const std::filesystem::path& path);

/// The fields of a file, binary where it ends in .solb, text otherwise.
/// @throws InvalidInput; IoError.
NodeFields read_plane_fields(const std::filesystem::path& path);

}  // namespace tetfarm
