/// Reads a UGRID file of tets (mesh/formats/ugrid/write_ugrid.h) piece by piece, in any binary
/// form.
#pragma once

#include <filesystem>
#include <memory>

#include "mesh/formats/mesh_source.h"
#include "mesh/formats/ugrid/ugrid_file.h"

namespace tetfarm {

/// As a listed mesh (listed_mesh.h), with the names of the .mapbc and the regions of the .regions
/// beside it. Boundary triangles may point either way, if all point the same way.
/// @throws IoError, InvalidInput with the byte.
std::unique_ptr<MeshSource> open_ugrid(const std::filesystem::path& path, UgridForm form = {},
                                       std::int64_t tets_of_piece = 1'000'000);

/// The same of one form, in place: without the scratch folder.
template <bool big_endian, bool wide>
std::unique_ptr<MeshSource> open_ugrid_as(const std::filesystem::path& path,
                                          const std::filesystem::path& scratch_folder);

}  // namespace tetfarm
