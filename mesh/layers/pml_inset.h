/// Which way absorbing layers (PML) of constant height grow inside of a given outer boundary, which
/// stays where it is.
///
/// Source: none in the thesis, whose layers grow outwards. On the faces of a box, straight or
/// skew, whose vertices would otherwise leave the smaller face within, each vertex goes its share
/// towards the middle: the layers are the box at smaller and smaller scales. Elsewhere vertices go
/// the way that pml_offset.h finds, backwards.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// For each vertex of the surface the way that moves the planes of its faces inwards by 1; zero for
/// vertices of other patches.
/// @param patches of the surface, ascending. @param thickness of all layers. @pre as for
/// pml_directions.
/// @throws UsageError as pml_directions does, and where a shell is no wider than twice the
/// thickness. Cost: O(n).
std::vector<Vec3> pml_ways_inwards(const SurfaceMesh& surface,
                                   std::span<const std::int32_t> patches, double thickness);

}  // namespace tetfarm
