/// Edge lengths, angles and unused vertices of a surface, for the report.
#pragma once

#include <span>

#include "mesh/core/surface_mesh.h"
#include "mesh/inspect/surface_edges.h"
#include "mesh/inspect/surface_report.h"

namespace tetfarm {

/// Fills the figures of the report (edges, smallest angle, unused vertices). Each edge counts once;
/// the median is the upper one. Cost: O(n).
void measure_surface(const SurfaceMesh& surface, std::span<const EdgeUse> uses,
                     SurfaceReport& report);

}  // namespace tetfarm
