/// The generators of cad_surfaces.h, a family in each file. All take a seed and a size from 0 to 3,
/// and give whole coordinates.
#pragma once

#include <cstdint>

#include "mesh/core/surface_mesh.h"

namespace tetfarm::shapes {

/// Cylinders, cones and stepped shafts whose ends are fans or strips of needles.
SurfaceMesh capped_cylinder(std::uint64_t seed, int size);
/// Nodes of up to 2,000 triangles: tips over outlines, middles of discs, corners of a hole.
SurfaceMesh fan_node(std::uint64_t seed, int size);
/// Bolts with a helical ridge.
SurfaceMesh thread(std::uint64_t seed, int size);
/// Plates with holes, through or blind, up to 1,000.
SurfaceMesh perforated_plate(std::uint64_t seed, int size);
/// Letters raised from or engraved into a plate.
SurfaceMesh lettering(std::uint64_t seed, int size);
/// Gears with a bore, a keyway, a hub and holes.
SurfaceMesh gear(std::uint64_t seed, int size);
/// Blocks with rounded edges: strips up to 1,000 times as long as wide.
SurfaceMesh rounded_block(std::uint64_t seed, int size);
/// Long bars of a section with rounded inner and outer corners.
SurfaceMesh filleted_bar(std::uint64_t seed, int size);
/// Prisms of any outline with nodes on their straight edges, others at the top than at the bottom.
SurfaceMesh split_extrusion(std::uint64_t seed, int size);
/// Level faces side by side whose heights differ by a millionth of the size.
SurfaceMesh fine_levels(std::uint64_t seed, int size);
/// Skins of cubes whose flat faces have become polygons.
SurfaceMesh merged_voxels(std::uint64_t seed, int size);
/// Unions and differences of boxes and upright prisms.
SurfaceMesh box_boolean(std::uint64_t seed, int size);

}  // namespace tetfarm::shapes
