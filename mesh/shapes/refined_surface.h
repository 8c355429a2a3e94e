/// A surface in finer triangles, the same to the last bit as a set of points: for meshes that are
/// much finer than the surface that they are made from.
///
/// Source: Rivara's bisection of the longest edge (Int. J. Numer. Methods Eng. 20, 1984). Departs
/// from it in that triangles are refined one by one: whether an edge is halved depends on its own
/// length alone, so that both sides of it are halved alike without knowing of each other.
#pragma once

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// A refined surface may have so many triangles.
inline constexpr double most_refined_triangles = 100'000'000;

/// Halves the longest edge of each triangle that has one longer than `longest_edge`, until none
/// has. The surface's vertices come first, as they were; patches and regions stay. No angle becomes
/// smaller than half of the smallest in its triangle. Edges so short beside their
/// coordinates that no double lies near their middle stay.
/// @throws UsageError when the length is not positive, or there would be more than
/// most_refined_triangles. Cost: O(n) of what comes out, 64 bytes for each triangle.
SurfaceMesh refined_surface(const SurfaceMesh& surface, double longest_edge);

}  // namespace tetfarm
