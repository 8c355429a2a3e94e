/// Angles at the rim: between a cut and the two surface triangles of a rim edge, through the
/// material.
///
/// Source: not in the thesis, where cuts at a fraction of a degree pass; small angles here become
/// bad elements. Convention: directions are unit vectors perpendicular to the edge. Angles are
/// compared by cosine, so that no decision depends on the rounding of a library's functions.
#pragma once

#include "mesh/core/subdomain.h"
#include "mesh/decompose/edge_loops.h"
#include "mesh/decompose/surface_topology.h"

namespace tetfarm {

/// The corner of the material at one rim edge.
struct RimCorner {
  Vec3 along;              // the edge's direction
  Vec3 into_left;          // within the left triangle, away from the edge
  Vec3 into_right;         // within the right triangle
  Vec3 left_inward;        // the inward normal of the left triangle
  Vec3 right_inward;       // of the right triangle
  bool is_convex = false;  // the material's angle is below 180 degrees
};

RimCorner rim_corner(const Subdomain& subdomain, const SurfaceTopology& topology,
                     const RimEdge& edge);

/// The direction that halves the material's angle.
Vec3 bisector(const RimCorner& corner);

/// The cosine of the angle at which a cut along the bisector would meet both sides.
double cosine_at_bisector(const RimCorner& corner);

/// The cosine of the smaller of the angles from the cut's direction to the two sides; 1 when the
/// direction is not inside the material.
double cosine_to_sides(const RimCorner& corner, const Vec3& into_cut);

/// From the edge ab towards c, perpendicular to ab, of length 1 (zero for a degenerate triangle).
Vec3 direction_into(const Vec3& a, const Vec3& b, const Vec3& c);

/// cos of an angle between 0 and 90 degrees, by + and * only.
double cosine_of_degrees(double degrees);

}  // namespace tetfarm
