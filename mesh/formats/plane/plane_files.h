/// The one door to files of meshes of the plane: the format is told by the ending of the name.
///
/// What there is to know of each format stands in the table of plane_files.cpp. Files that are read
/// may be packed by gzip (".gz" behind the ending).
#pragma once

#include <filesystem>
#include <string>

#include "mesh/formats/plane/plane_medit.h"
#include "mesh/planar/plane_mesh.h"

namespace tetfarm {

/// For commands that work long before they write. @throws UsageError for an ending that is not
/// known, naming those that are.
void require_plane_input_name(const std::filesystem::path& path);
void require_plane_output_name(const std::filesystem::path& path);

/// @throws UsageError as above; InvalidInput with the file and the line or byte; IoError.
PlaneMesh read_plane_mesh(const std::filesystem::path& path);

/// The same of bytes, by the ending of `name`.
PlaneMesh read_plane_mesh(std::string_view bytes, const std::string& name);

/// @pre triangles are anticlockwise, and the numbers of nodes are those of points.
/// @throws UsageError as above; IoError.
void write_plane_mesh(const PlaneMesh& mesh, const std::filesystem::path& path);

}  // namespace tetfarm
