/// Exact geometric predicates: the sign is always right, whatever the rounding.
///
/// Source: J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
/// Predicates" (1997): a static error bound first, then exact expansions. Perturbation: O.
/// Devillers and M. Teillaud, "Perturbations for Delaunay and weighted Delaunay 3D triangulations"
/// (2011). Orientation: as in mesh/core/tet_mesh.h. Needs IEEE doubles without contraction;
/// coordinates must be finite and between 1e-60 and 1e60 in size, or 0. Cost: some 10 flops when
/// the bound decides; up to a few microseconds when it does not.
#pragma once

#include <cstdint>

#include "mesh/core/vec3.h"

namespace tetfarm {

struct Vec2 {
  double x = 0;
  double y = 0;
  friend bool operator==(const Vec2&, const Vec2&) = default;
};

/// Positive when a, b, c turn anticlockwise; 0 exactly when collinear. Only the sign is exact.
double orient2d(const Vec2& a, const Vec2& b, const Vec2& c);

/// Positive when d is inside the circle through a, b, c (anticlockwise); 0 exactly when cocircular.
double incircle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

/// 6 · tet_volume(a, b, c, d): the sign is exact, 0 when coplanar, the size right to rounding.
double orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Positive when e is inside the sphere through a, b, c, d (orient3d > 0); 0 exactly on the sphere.
double insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);

/// As insphere > 0, but never undecided: cospherical points are perturbed in the order of `ids`
/// (ids[0..3] of a..d, ids[4] of e; all different).
bool in_perturbed_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                         const std::int32_t (&ids)[5]);

/// The same without the try in plain doubles, for where filtered_insphere was not certain.
bool in_perturbed_sphere_exactly(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                                 const Vec3& e, const std::int32_t (&ids)[5]);

}  // namespace tetfarm
