/// Writes a mesh as Medit/GMF binary (.meshb) of version 4: integers and places in the file of 64
/// bits, coordinates in double precision.
///
/// Source: the GMF format as libMeshb documents it. References are the number of the patch of a
/// face and of the region of a cell, from 1; the format has no names.
#pragma once

#include <filesystem>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// @throws IoError, what the source throws. One pass; memory of one part.
void write_meshb(const MeshSource& source, const MeshOutline& outline,
                 const std::filesystem::path& file);

}  // namespace tetfarm
