/// Where the outer boundary of a domain goes when a block of absorbing layers (PML) of constant
/// height is put round it: each vertex moves outwards until the planes of its faces have all moved
/// by the same distance.
///
/// Source: thesis 4.4.3, whose layers grow outwards; here the boundary is moved first, and layers
/// grow inwards from it, back to where it was. Which way a vertex goes is not the thesis's: a
/// sphere stays a sphere round the same centre, and up to three planes stay planes, so that a box
/// stays a box. Elsewhere it is the axis of the smallest cone round the normals.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// Planes count as one plane where the sine of the angle between them is less.
inline constexpr double same_plane_sine = 1e-9;
/// All vertices of a shell lie on a sphere where none is further off than this share of its radius.
inline constexpr double sphere_tolerance = 1e-9;

/// For each vertex of the surface the way outwards that moves the planes of its faces by 1, or its
/// radius by 1 on a sphere; zero for vertices of other patches.
/// @param patches of the surface, ascending. @pre the surface is one without defects, of one
/// region.
/// @throws UsageError when the patches are not whole closed shells, when one of these bounds a hole
/// in the domain, and where no single direction sees all faces at a vertex. Cost: O(n).
std::vector<Vec3> pml_directions(const SurfaceMesh& surface, std::span<const std::int32_t> patches);

/// The surface with each vertex `thickness` further along its direction.
/// @throws UsageError naming the triangles when it meets itself there, or is turned. Cost: that of
/// check_surface.
SurfaceMesh moved_outwards(const SurfaceMesh& surface, std::span<const Vec3> directions,
                           double thickness);

}  // namespace tetfarm
