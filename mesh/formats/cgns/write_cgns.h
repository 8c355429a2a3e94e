/// Writes a mesh as CGNS in HDF5 with 64-bit integers, without CGNS's own library, whose usual
/// builds have 32.
///
/// Source: CGNS/SIDS and "SIDS-to-HDF5 file mapping". One Base, one Zone1; all tetrahedra are the
/// section GridElements, each patch a section of triangles, a BC and a Family of its own (what
/// kind of boundary it is, the user has to say); region and
/// sub-domain of each tetrahedron are in the solution CellData. Names are plain, at most 32 bytes.
#pragma once

#include <filesystem>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// @throws IoError, what the source throws. One pass; memory of one part.
void write_cgns(const MeshSource& source, const MeshOutline& outline,
                const std::filesystem::path& file);

}  // namespace tetfarm
