/// Writes any mesh as VTKHDF, a partition for each of its parts.
#pragma once

#include <filesystem>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// As write_vtkhdf (write_vtkhdf.h). @throws IoError, what the source throws. One pass; memory of
/// one part.
void export_vtkhdf(const MeshSource& source, const MeshOutline& outline,
                   const std::filesystem::path& file);

}  // namespace tetfarm
