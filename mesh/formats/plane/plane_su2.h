/// Meshes of the plane as SU2 text (.su2, NDIME= 2), with a marker for each patch.
///
/// Source: SU2 documentation, "Mesh file". Lists may come in any order. The format has no place for
/// regions, for corners, nor for edges inside the domain.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "mesh/planar/plane_mesh.h"

namespace tetfarm {

/// Patches are the markers, numbered from 1 in the order of the file, with their names.
/// @throws InvalidInput with the line: elements other than triangles, markers of other things than
/// lines, numbers of nodes that are not there.
PlaneMesh read_plane_su2(std::string_view bytes, const std::string& name);

/// Names of markers are plain (plain_names.h). Edges that no triangle uses at one side only are
/// left out. @throws IoError; InvalidInput when more than two triangles have a side.
void write_plane_su2(const PlaneMesh& mesh, const std::filesystem::path& path);

}  // namespace tetfarm
