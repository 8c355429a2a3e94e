/// Reads a VTKHDF file that write_vtkhdf wrote, or another one of tets and triangles.
#pragma once

#include <filesystem>

#include "mesh/assemble/mesh_report.h"

namespace tetfarm {

/// Partitions are joined by the point array GlobalNodeId; without it there must be one partition.
/// Without the cell array `patch` all boundary triangles are of patch 0.
/// @throws IoError, InvalidInput.
GlobalMesh read_vtkhdf(const std::filesystem::path& path);

}  // namespace tetfarm
