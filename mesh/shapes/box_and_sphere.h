/// A box and a sphere, evenly triangulated and oriented outward: outer boundaries are made of them.
///
/// Only + − × ÷ and sqrt make the coordinates: the same bits on every machine. Without patches.
#pragma once

#include <array>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// Each face is n × n squares of two triangles, whose diagonals run from the corners of the face
/// towards its middle, so that no tetrahedron is forced into a corner of the box: 12 n² triangles.
/// The corners are exactly those of the box. @pre n > 0.
SurfaceMesh box_surface(const Box3& box, int n);
/// The same with so many squares along each axis.
SurfaceMesh box_surface(const Box3& box, const std::array<int, 3>& n);

/// A face of a box: across which axis, and at its low end (0) or its high end (1).
struct BoxFace {
  int axis = 0;
  int end = 0;
};

/// The same without one of its faces.
SurfaceMesh open_box_surface(const Box3& box, const std::array<int, 3>& n, const BoxFace& open);

/// An icosahedron with each edge in n parts, blown up to the sphere: 20 n² triangles. @pre n > 0.
SurfaceMesh sphere_surface(const Vec3& centre, double radius, int n);

/// Half of an octahedron with each edge in n parts, blown up to the sphere, on one side (1 or -1)
/// of the plane through its centre across an axis: 4 n² triangles. Its rim lies in that plane to
/// the last bit. @pre n > 0.
SurfaceMesh half_sphere_surface(const Vec3& centre, double radius, int n, int axis, int side);

/// The least distance from the centre to the plane of a triangle.
double nearest_plane(const SurfaceMesh& sphere, const Vec3& centre);

}  // namespace tetfarm
