#include "mesh/shapes/nested_shapes.h"

#include "mesh/shapes/box_and_sphere.h"
#include "mesh/shapes/patched_surface.h"

namespace tetfarm {
namespace {

/// Its 20 n^2 triangles have together the area of the sphere: n = 1.2046 radius / edge.
SurfaceMesh even_sphere(double radius, double spacing) {
  constexpr double parts_at_spacing_1 = 1.2046;
  return sphere_surface({}, radius, parts_of_length(parts_at_spacing_1 * radius, spacing, 2));
}

SurfaceMesh sphere_inside(const SurfaceMesh& outer, double spacing) {
  PatchedSurface surface;
  surface.begin_patch("outer");
  surface.add_surface(outer, false);
  surface.begin_patch("inner");
  surface.add_surface(even_sphere(1, spacing), true);
  return surface.take();
}

}  // namespace

SurfaceMesh sphere_in_sphere(double spacing) {
  return sphere_inside(even_sphere(2, spacing), spacing);
}

SurfaceMesh sphere_in_box(double spacing) {
  return sphere_inside(box_surface({{-2, -2, -2}, {2, 2, 2}}, parts_of_length(4, spacing, 2)),
                       spacing);
}

}  // namespace tetfarm
