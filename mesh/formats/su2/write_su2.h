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

/// NAME.su2 gets NAME.cfg, when one of its patches is specified: what a configuration of SU2 says
/// of the mesh and its markers, for the user to complete. A NAME.cfg that is there stays as it is.
/// @throws IoError.
void write_beside_su2(const MeshSource& source, const MeshOutline& outline,
                      const std::filesystem::path& file);

}  // namespace tetfarm
