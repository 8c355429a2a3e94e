/// The triangles of a surface that cannot be meshed, in a file to look at.
#pragma once

#include <string>

#include "cli/job_input.h"
#include "mesh/core/surface_mesh.h"
#include "mesh/inspect/surface_report.h"

namespace tetfarm {

/// @param asked a file, a folder, or empty: NAME.defects.vtp here. @throws Error (bad_geometry)
/// that names the defects and the file, once it is written; IoError.
void require_no_defects(const SurfaceMesh& surface, const SurfaceReport& report,
                        const JobInput& input, const std::string& asked);

}  // namespace tetfarm
