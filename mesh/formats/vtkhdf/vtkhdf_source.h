/// Opens a VTKHDF file of tets (read_vtkhdf.h) partition by partition.
#pragma once

#include <filesystem>
#include <memory>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// Read in place, without the scratch folder; several partitions are joined by GlobalNodeId, which
/// they must have. @throws IoError, InvalidInput.
std::unique_ptr<MeshSource> open_vtkhdf(const std::filesystem::path& path,
                                        const std::filesystem::path& scratch_folder);

}  // namespace tetfarm
