/// Writes a mesh as SU2 (.su2), text: cells, nodes, a marker for each patch.
///
/// Source: SU2 documentation, "Mesh File". Names of markers are plain (plain_names.h). The format
/// has no place for regions.
#pragma once

#include <filesystem>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// @throws IoError, what the source throws. One pass; memory of one part.
void write_su2(const MeshSource& source, const MeshOutline& outline,
               const std::filesystem::path& file);

}  // namespace tetfarm
