/// Meshes of the plane as CGNS in HDF5 (.cgns), with 64-bit integers.
///
/// Source: CGNS/SIDS and "SIDS-to-HDF5 file mapping". One Base of two dimensions, one Zone1; the
/// triangles are the section GridElements, each patch of the border a section of lines, a BC and a
/// Family of its own (what kind of boundary it is, the user has to say); the region of each
/// triangle is in the solution CellData. Names are plain, at most 32 bytes. Edges inside are left
/// out.
#pragma once

#include <filesystem>

#include "mesh/planar/plane_mesh.h"

namespace tetfarm {

/// @throws IoError; InvalidInput when more than two triangles have a side.
void write_plane_cgns(const PlaneMesh& mesh, const std::filesystem::path& path);

}  // namespace tetfarm
