/// Writes a mesh as Gmsh MSH 2.2, text, for programs that do not know 4.1.
///
/// Source: Gmsh reference manual, "MSH file format version 2". Tags of an element are its physical
/// group (patch or region), its entity (patch, or sub-domain), and of a tetrahedron its partition.
#pragma once

#include <filesystem>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// @throws IoError, what the source throws. One pass; memory of one part.
void write_msh22(const MeshSource& source, const MeshOutline& outline,
                 const std::filesystem::path& file);

}  // namespace tetfarm
