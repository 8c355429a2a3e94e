/// Files that show a person what is wrong with a surface.
#pragma once

#include <string>
#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/inspect/surface_check.h"
#include "worker/task_io.h"

namespace tetfarm {

/// The bytes of the .vtp file of the defects (write_defects_vtp). @throws IoError.
std::string defects_as_vtp(const TaskIo& io, const SurfaceMesh& surface,
                           const std::vector<SurfaceDefect>& defects);

/// "triangle 17 of the input" or "triangle 3 of the cut of LR", and its centroid.
std::string describe_triangle(const Subdomain& subdomain, std::int32_t triangle);

/// The message for a sub-domain that cannot be meshed: its name, the reason, the first few
/// triangles.
std::string subdomain_message(const Subdomain& subdomain, const std::string& reason,
                              const std::vector<std::int32_t>& triangles);

}  // namespace tetfarm
