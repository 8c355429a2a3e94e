/// A triangulated surface: the input geometry, and the boundary of every sub-domain.
///
/// Orientation: each triangle is anticlockwise seen from outside the domain, so its normal points
/// out of the material that is to be meshed. Lengths are in the unit of the input.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/core/vec3.h"

namespace tetfarm {

using Triangle = std::array<std::int32_t, 3>;

/// The regions on the two sides of a triangle: [0] behind it, [1] in front, where its normal
/// points. Regions of the domain count from 1; 0 is what is not meshed.
using Sides = std::array<std::int32_t, 2>;

/// Invariants (unmatched_edges in mesh/core/validate.h tells of 3):
///  1. every index is in [0, vertices.size()), the three of a triangle differ;
///  2. patch_of_triangle is empty or has one entry for each triangle, an index into patch_names;
///  3. of a *domain* surface of one region: every edge is used once in each direction;
///  4. of a domain surface of several: sides has one entry for each triangle, the two differ or are
///     both 0, and the triangles of each region, turned to point out of it, are such a surface.
struct SurfaceMesh {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::int32_t> patch_of_triangle;
  std::vector<std::string> patch_names;
  std::vector<Sides> sides;               ///< empty: region 1 behind every triangle, 0 in front
  std::vector<std::string> region_names;  ///< of regions 1, 2, …; empty: one region without a name
};

inline Sides sides_of(const SurfaceMesh& surface, std::size_t triangle) {
  return surface.sides.empty() ? Sides{1, 0} : surface.sides[triangle];
}

/// 0 where the surface has no patches.
inline std::int32_t patch_of(const SurfaceMesh& surface, std::size_t triangle) {
  return surface.patch_of_triangle.empty() ? 0 : surface.patch_of_triangle[triangle];
}

/// Between how many regions of the domain the triangle lies: 0 (inside what is not meshed), 1,
/// or 2.
inline int meshed_sides(const SurfaceMesh& surface, std::size_t triangle) {
  const Sides sides = sides_of(surface, triangle);
  return (sides[0] > 0 ? 1 : 0) + (sides[1] > 0 ? 1 : 0);
}

/// Of all triangles.
std::int64_t meshed_sides(const SurfaceMesh& surface);

/// At least 1.
std::int32_t region_count(const SurfaceMesh& surface);

/// The volume of all regions. @pre the invariants of a domain surface.
double domain_volume(const SurfaceMesh& surface);

/// The volume enclosed by a closed surface; positive when normals point outward.
double enclosed_volume(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles);

Box3 bounding_box(const std::vector<Vec3>& points);

}  // namespace tetfarm
