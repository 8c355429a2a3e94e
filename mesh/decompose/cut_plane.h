/// A cutting plane with a frame of its own: two coordinates in it, and the height above it.
///
/// Source: thesis 4.3.1.4 (rotation of the domain into the plane, eq. 18-20): here the three axes
/// of the frame are kept instead of the matrices. Left is below (negative height), right is above.
#pragma once

#include "mesh/core/vec3.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {

/// Which planes are tried.
enum class CutPlanes {
  automatic,  // all, those of the lattice first where they cost little
  lattice,    // {110} planes of the point lattice: no lattice tet is cut
  axis,       // orthogonal to the axes
  inertia,    // orthogonal to the principal axes of the work's inertia
};

/// u, v, normal: orthonormal and right-handed.
struct CutPlane {
  Vec3 normal;
  Vec3 u;
  Vec3 v;
  double offset = 0;  // along the normal

  double height(const Vec3& p) const { return dot(normal, p) - offset; }
  Vec2 project(const Vec3& p) const { return {dot(u, p), dot(v, p)}; }
  Vec3 lift(const Vec2& p, double height_above) const {
    return p.x * u + p.y * v + (offset + height_above) * normal;
  }
};

/// @pre `unit_normal` has length 1. An axis as normal gives axes as u and v, so that projecting
/// rounds nothing.
CutPlane make_cut_plane(const Vec3& unit_normal, double offset);

}  // namespace tetfarm
