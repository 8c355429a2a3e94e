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

/// Invariants (unmatched_edges in mesh/core/validate.h tells of 3):
///  1. every index is in [0, vertices.size()), the three of a triangle differ;
///  2. patch_of_triangle is empty or has one entry for each triangle, an index into patch_names;
///  3. of a *domain* surface: every edge is used once in each direction.
struct SurfaceMesh {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::int32_t> patch_of_triangle;
  std::vector<std::string> patch_names;
};

/// The volume enclosed by a closed surface; positive when normals point outward.
double enclosed_volume(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles);

Box3 bounding_box(const std::vector<Vec3>& points);

}  // namespace tetfarm
