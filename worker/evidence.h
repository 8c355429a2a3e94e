/// Files that show a person what is wrong with a surface, and what a sub-domain's task ends with.
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

/// The input is to blame: subdomain_message, and a .vtp file of the triangles. @throws IoError.
RefusedInput refused_subdomain(const TaskIo& io, const Subdomain& subdomain,
                               const std::string& reason,
                               const std::vector<std::int32_t>& triangles);

/// Tetfarm is to blame: a valid surface was not recovered. With the same .vtp, and with the
/// sub-domain's surface as an OFF file whose coordinates are exact, which is enough to repeat it.
/// @throws IoError.
OwnDefect unrecovered_subdomain(const TaskIo& io, const Subdomain& subdomain,
                                const std::string& reason,
                                const std::vector<std::int32_t>& triangles);

}  // namespace tetfarm
