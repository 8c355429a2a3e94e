/// What healing has done to a surface, act by act, and what its steps share.
///
/// Lengths in the unit of the input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/geometry/triangle_intersection.h"
#include "mesh/inspect/surface_edges.h"

namespace tetfarm {

/// In the order in which they are told.
enum class HealKind : std::uint8_t {
  joined,       ///< vertices that lie within the tolerance of each other
  duplicate,    ///< a triangle that was there more than once
  fold,         ///< two triangles of the same corners that lay back to back
  flat,         ///< a triangle without area
  nearly_flat,  ///< a triangle of next to no height
  seam,         ///< an edge that was divided where a vertex lay on it
  hole,         ///< filled
  crossing,     ///< triangles in each other's way, replaced
  united,       ///< a shell that goes through others or itself
  inside,       ///< a shell that lay inside others, removed
};
inline constexpr std::size_t heal_kinds = static_cast<std::size_t>(HealKind::inside) + 1;

struct HealAct {
  HealKind kind = HealKind::joined;
  Vec3 at;
  std::vector<TrianglePoints> triangles;  ///< made, or where none was made removed
};

/// What the steps work on.
struct HealingWork {
  SurfaceMesh& surface;
  double tolerance = 0;
  double largest_hole = 0;  ///< length of its border
  double largest_move = 0;  ///< of what is put in place of crossing triangles
  std::vector<HealAct>& acts;
};

/// Adds a triangle of the patch that another has.
void add_triangle(SurfaceMesh& surface, const Triangle& nodes, std::int32_t patch);

/// The same of all that an act makes, which then shows them.
void add_triangles(SurfaceMesh& surface, std::span<const Triangle> made, std::int32_t patch,
                   HealAct& act);

/// Removes the triangles that are marked; the others keep their order. Cost: O(n).
void remove_triangles(SurfaceMesh& surface, const std::vector<char>& is_gone);

inline const Vec3& vertex_at(const SurfaceMesh& surface, std::int32_t v) {
  return surface.vertices[static_cast<std::size_t>(v)];
}

/// Those of one edge. @pre `uses` are sorted, as edge_uses gives them. Cost: O(log n).
std::span<const EdgeUse> uses_of_edge(std::span<const EdgeUse> uses, std::int32_t a,
                                      std::int32_t b);

/// The triangle's vertices. @pre its numbers are in range.
inline TrianglePoints points_of(const SurfaceMesh& surface, std::size_t triangle) {
  return triangle_points(surface.vertices, surface.triangles[triangle]);
}

}  // namespace tetfarm
