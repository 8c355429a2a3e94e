/// Reads a CGNS file of tets, as mesh/formats/cgns/write_cgns.h writes it, piece by piece, through
/// HDF5.
#pragma once

#include <filesystem>
#include <memory>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// As a listed mesh (listed_mesh.h), without the scratch folder. Sections of triangles are patches,
/// in their order. Sub-domains and regions are those of the solution CellData; without it the file
/// knows neither.
/// @throws IoError, InvalidInput with what is missing or unfit.
std::unique_ptr<MeshSource> open_cgns(const std::filesystem::path& path,
                                      const std::filesystem::path& scratch_folder);

}  // namespace tetfarm
