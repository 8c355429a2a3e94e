/// The dihedral angle that a surface forces on every mesh of it: an upper bound for the smallest.
///
/// Source: none in the thesis. Where two triangles of the surface meet in an edge, the tets at the
/// edge share the angle theta of the material between them. Two tets or more: one has theta / 2 at
/// most. One: it has both triangles as faces, so that its four nodes, and all its angles, are
/// known. The better of the two cases bounds every mesh that keeps the surface. Nothing like it
/// holds for a needle triangle by itself: of the tets on a triangle with two long sides, the slim
/// pyramid has dihedral angles near 60 and 90 degrees however thin it is; it only takes nodes as
/// near to each other as the triangle's short side. Units: degrees.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "mesh/core/tet_mesh.h"

namespace tetfarm {

struct ForcedDihedral {
  /// No mesh of the surface has a larger smallest dihedral angle. 70.6 when nothing is forced, as
  /// no tet has more than 70.53.
  double at_most_deg = 70.6;
  /// The middle of the edge that forces it.
  Vec3 at;
};

/// The bound of one edge uv: of the triangles (u, v, left) and (v, u, right), normals outwards.
double forced_dihedral_at_edge(const Vec3& u, const Vec3& v, const Vec3& left, const Vec3& right);

/// Edge uv of exactly the triangles (u, v, left) and (v, u, right), by their numbers.
struct EdgeOfTwo {
  std::int32_t u = 0;
  std::int32_t v = 0;
  std::int32_t left = 0;
  std::int32_t right = 0;
};

/// Calls visit for each such edge, by rising nodes. Cost: O(n log n).
void for_each_edge_of_two(std::span<const Triangle> triangles,
                          const std::function<void(const EdgeOfTwo&)>& visit);

/// The smallest bound of all edges that belong to two triangles, the first of equals by its nodes.
/// @pre the triangles' normals point out of the domain. Cost: O(n log n).
ForcedDihedral forced_dihedral(std::span<const Vec3> nodes, std::span<const Triangle> boundary);

/// The smallest of the regions of a surface, each bounded by its triangles, turned out of it.
ForcedDihedral forced_dihedral(const SurfaceMesh& surface);

}  // namespace tetfarm
