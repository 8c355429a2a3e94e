/// Invalid zones: where a cutting plane would rather not be placed.
///
/// A plane that lies close to a stretch of surface almost parallel to it (a wing tip, a leading
/// edge) traps thin elements between the two. Source: thesis 4.3.1.4, procedure "findvalidregions",
/// figures 51 and 52. A departure: as a veto the zones stop most real models after a few cuts
/// (measured), so they are weighed against balance instead; how much area a zone has tells how bad
/// it is.
#pragma once

#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/decompose/surface_topology.h"

namespace tetfarm {

/// For a plane with this normal at each of `offsets`: the area of the input triangles (not of
/// earlier cuts) within 30 degrees of parallel to it that it passes at less than their own edge
/// length.
/// Of many triangles, every n-th stands for n.
/// @pre `unit_normal` has length 1. Cost: O(triangles + parallel triangles * offsets).
std::vector<double> area_in_invalid_zones(const Subdomain& subdomain,
                                          const SurfaceTopology& topology, const Vec3& unit_normal,
                                          const std::vector<double>& offsets);

}  // namespace tetfarm
