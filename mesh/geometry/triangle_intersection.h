/// Whether two triangles, or a segment and a triangle, have points in common, and of what kind.
///
/// Every answer is exact for the coordinates as given: signs of mesh/geometry/predicates.h only, no
/// tolerance. Corners count as shared where their coordinates are equal, or, in
/// `triangles_meet_beyond_shared`, where their numbers are.
/// Source: P. Guigue and O. Devillers, "Fast and robust triangle-triangle overlap test using
/// orientation predicates" (2003), for two triangles that straddle each other's planes; the rest is
/// separating lines in a plane. Use: thesis 4.3.1.7 (a cut must not intersect the surface) and the
/// check of the input. Coordinates as predicates.h wants them. A triangle without area
/// (is_degenerate) has no contact. Cost: 3 to some 30 signs.
#pragma once

#include <array>
#include <span>

#include "mesh/core/surface_mesh.h"
#include "mesh/core/vec3.h"

namespace tetfarm {

using TrianglePoints = std::array<Vec3, 3>;

inline TrianglePoints triangle_points(std::span<const Vec3> vertices, const Triangle& t) {
  const auto at = [&vertices](std::int32_t v) { return vertices[static_cast<std::size_t>(v)]; };
  return {at(t[0]), at(t[1]), at(t[2])};
}

enum class TriangleContact {
  none,
  /// They share points, but nothing of what follows: a corner in the other triangle, edges along
  /// each other, a shared corner or edge.
  touching,
  /// They lie in one plane and share area.
  overlapping,
  /// They do not lie in one plane, and points inside both are shared, or two edges cross each other
  /// between their ends.
  crossing,
};

/// The strongest contact of the two closed triangles.
TriangleContact triangle_contact(const TrianglePoints& a, const TrianglePoints& b);

/// The check of a cut: touching, shared corners and edges, and anything in one plane are no hit.
inline bool triangles_cross(const TrianglePoints& a, const TrianglePoints& b) {
  return triangle_contact(a, b) == TriangleContact::crossing;
}

/// The check of a surface: true when two of its triangles share any point that is not on a corner
/// or an edge that both have (by vertex number). True for the same three vertices twice.
bool triangles_meet_beyond_shared(std::span<const Vec3> vertices, const Triangle& a,
                                  const Triangle& b);

/// Whether the closed segment pq and the closed triangle share a point.
bool segment_meets_triangle(const Vec3& p, const Vec3& q, const TrianglePoints& t);

/// Whether pq, strictly between p and q, goes through the triangle's plane at a point inside the
/// triangle or inside one of its edges. Through a corner is no crossing.
bool segment_crosses_triangle(const Vec3& p, const Vec3& q, const TrianglePoints& t);

/// Whether the area is exactly zero: equal or collinear corners.
bool is_degenerate(const TrianglePoints& t);

}  // namespace tetfarm
