/// Writes a mesh as Gmsh MSH 4.1, binary or text: one file.
///
/// Source: Gmsh reference manual, "MSH file format". A volume entity is a sub-domain and its
/// physical group the region; a surface entity and its physical group are a patch. Nodes and
/// elements are numbered from 1, all 64-bit.
#pragma once

#include <filesystem>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// @throws IoError, what the source throws. One pass; memory of one part.
void write_msh41_binary(const MeshSource& source, const MeshOutline& outline,
                        const std::filesystem::path& file);
void write_msh41_text(const MeshSource& source, const MeshOutline& outline,
                      const std::filesystem::path& file);

}  // namespace tetfarm
