/// The generators of generated_surfaces.h that are skins of the cells of a grid.
#pragma once

#include <cstdint>

#include "mesh/core/surface_mesh.h"

namespace tetfarm::shapes {

/// Cells by chance; many touch along an edge and are told to be invalid.
SurfaceMesh voxels(std::uint64_t seed, int size);
/// A plate with square holes: its genus is their number.
SurfaceMesh handles(std::uint64_t seed, int size);
/// A box of squares, its cospherical corners with diagonals by chance, some at random heights.
SurfaceMesh grid(std::uint64_t seed, int size);
/// A cube of cubes: cells are left out at the odd places, as holes inside or as tunnels through
/// all.
SurfaceMesh cubes(std::uint64_t seed, int size);

}  // namespace tetfarm::shapes
