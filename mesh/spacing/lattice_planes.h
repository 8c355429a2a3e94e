/// The {110} planes of the job's body-centred lattice, along which a cut leaves no scar.
///
/// Source: docs/kernel.md, "Planes of the lattice" (the thesis has axis and inertia planes only).
#pragma once

#include <optional>

#include "mesh/spacing/spacing_octree.h"

namespace tetfarm {

/// As SpacingField::coarsest_lattice_plane. Cells of twice the edge have nodes in every other of
/// the planes; so the rounder the number of a plane, the larger the cells whose nodes it holds.
std::optional<LatticePlane> coarsest_lattice_plane(const GridFrame& frame, std::size_t direction,
                                                   double least_offset, double largest_offset);

}  // namespace tetfarm
