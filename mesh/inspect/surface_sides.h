/// The sides of a surface's triangles, joined where one can walk from one to the next without
/// passing through the surface.
///
/// Source: round each edge the triangles are put in order of angle, exactly; the back or front of
/// one faces the back or front of the next. So each set of joined sides is a closed surface that
/// bounds one region on that side, also where more than two triangles meet in an edge.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/inspect/surface_edges.h"

namespace tetfarm {

/// A triangle's side as a number: 2 t behind it, 2 t + 1 in front.
constexpr std::size_t side_behind(std::size_t triangle) { return 2 * triangle; }
constexpr std::size_t side_in_front(std::size_t triangle) { return 2 * triangle + 1; }

struct SurfaceSides {
  std::vector<std::int32_t> side2sheet;     ///< joined sides, numbered by their first side
  std::vector<std::int32_t> triangle2part;  ///< triangles joined over edges, by their first
  std::int32_t sheets = 0;
  std::int32_t parts = 0;
};

/// @pre the surface has no defects: every edge has two triangles or more, none intersect.
/// Cost: O(n), and k log k exact signs for an edge of k > 2 triangles.
SurfaceSides join_sides(const SurfaceMesh& surface, std::span<const EdgeUse> uses);

}  // namespace tetfarm
