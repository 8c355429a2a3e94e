/// Meshes of the plane as Gmsh's files (.msh): read in versions 2.2 and 4.1, text and binary,
/// written as text of version 2.2, which more programs read.
///
/// Source: Gmsh reference manual, "MSH file format". Physical groups of lines are patches, those of
/// surfaces regions, with their numbers and names.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "mesh/planar/plane_mesh.h"

namespace tetfarm {

/// Lines are edges that stay, also inside. Elements without a physical group get the number 0.
/// @throws InvalidInput with the line or byte: other elements of two or three dimensions than
/// triangles, lines of higher order, nodes that are not there or do not lie in a plane z =
/// constant.
PlaneMesh read_plane_msh(std::string_view bytes, const std::string& name);

/// @throws IoError.
void write_plane_msh(const PlaneMesh& mesh, const std::filesystem::path& path);

}  // namespace tetfarm
