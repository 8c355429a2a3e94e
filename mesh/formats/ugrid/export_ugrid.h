/// Writes any mesh as UGRID, and beside it the names of its patches and which tets are of which
/// region.
#pragma once

#include <filesystem>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// As write_ugrid (write_ugrid.h). @throws Error when the integers cannot hold the counts; IoError,
/// what the source throws. One pass; memory of one part.
template <bool big_endian, bool wide>
void export_ugrid(const MeshSource& source, const MeshOutline& outline,
                  const std::filesystem::path& file);

/// NAME.b8.ugrid gets NAME.mapbc, and NAME.regions when there are several. Reads every part once
/// more when some patch is a plane of symmetry. @throws IoError, what the source throws.
void write_beside_ugrid(const MeshSource& source, const MeshOutline& outline,
                        const std::filesystem::path& file);

}  // namespace tetfarm
