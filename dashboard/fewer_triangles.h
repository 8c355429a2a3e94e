/// A surface with fewer triangles, for pictures: vertices that lie in one cell of a regular grid
/// become one, and the triangles that have their corners in three cells are left.
///
/// **Source.** Rossignac and Borrel 1993 (vertex clustering), with the mean of the vertices of a
/// cell as its one. The grid is the finest that leaves few enough triangles, as bisection finds it.
/// The result is no valid surface: it may touch itself. The same input gives the same result.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

struct FewerTriangles {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> was;  ///< which triangle of the surface each was
};

/// At most `most` triangles; those of the surface, all of them, where they are not more.
/// @pre every index is of a vertex, coordinates are finite and below 1e30.
/// Cost: O(13 (V + T) + n log n) for n that are left.
FewerTriangles fewer_triangles(const std::vector<Vec3>& vertices,
                               const std::vector<Triangle>& triangles, std::size_t most);

}  // namespace tetfarm
