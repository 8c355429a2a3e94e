/// Fills a closed loop of edges with triangles of the least area.
///
/// Source: G. Barequet and M. Sharir, "Filling gaps in the boundary of a polyhedron" (1995): the
/// best triangulation of a part of the loop is that of two smaller parts and a triangle between.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// Longer loops are not filled.
inline constexpr std::size_t longest_loop = 200;

/// Whether an edge between two vertices of the loop must not be made.
using IsTaken = std::function<bool(std::int32_t a, std::int32_t b)>;

/// Triangles whose border is the loop, in its direction; none of them without area, none with an
/// edge that is taken. Nothing where there are none such, or the loop is too long.
/// @pre the loop has each vertex once, and at least three. Cost: O(k^3) for k vertices.
std::optional<std::vector<Triangle>> fill_loop(std::span<const Vec3> vertices,
                                               std::span<const std::int32_t> loop,
                                               const IsTaken& is_taken);

}  // namespace tetfarm
