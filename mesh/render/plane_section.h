/// Where a plane cuts the cells of a mesh: a polygon in each, true to scale.
///
/// Source: the cuts through layers of the thesis (figs. 97 to 100). What lies in the plane counts
/// as above it, so that cells which only touch the plane have no section, and neighbours have the
/// same points.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/assemble/global_mesh.h"

namespace tetfarm {

struct CellSection {
  std::int64_t cell = 0;      ///< tets first, then those in blocks, type after type
  std::vector<Vec3> corners;  ///< three or more, one after the other round the polygon
};

/// The plane: points p with dot(normal, p) = at. A cell whose faces are bent may have two polygons.
/// In the order of the cells. Cost: O(n).
std::vector<CellSection> plane_section(const NumberedPart& part, const Vec3& normal, double at);

}  // namespace tetfarm
