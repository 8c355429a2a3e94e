/// Named tiny shapes for tests. All are closed and oriented outward of the domain unless said
/// otherwise.
#pragma once

#include "mesh/core/surface_mesh.h"

namespace tetfarm::shapes {

SurfaceMesh tetrahedron();
/// [0,1]^3 with 12 triangles.
SurfaceMesh unit_cube();
/// A box whose faces are n x n squares of two triangles each.
SurfaceMesh box(const Vec3& low, const Vec3& high, int n);
/// An icosphere: 20 * 4^levels triangles.
SurfaceMesh sphere(const Vec3& centre, double radius, int levels);
/// Both shells in one mesh; `inner` reversed so that the domain lies between them.
SurfaceMesh between(const SurfaceMesh& outer, const SurfaceMesh& inner);
/// A sphere of radius 1 in a sphere of radius 0.4 (levels each).
SurfaceMesh nested_spheres(int levels);
/// A torus round the z axis: major radius 1, minor radius `minor`, n x m quads.
SurfaceMesh torus(double minor, int n, int m);

}  // namespace tetfarm::shapes
