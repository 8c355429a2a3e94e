/// A surface with its features, ready for single changes.
#pragma once

#include <utility>

#include "mesh/remeshing/surface_replacement.h"
#include "mesh/remeshing/surface_to_remesh.h"

namespace tetfarm {

struct SurfaceToChange {
  SurfaceToChange(SurfaceMesh input, double wanted, double tolerance)
      : mesh(std::move(input)),
        features(surface_features(mesh, 30)),
        shape(mesh, features, std::vector<double>(mesh.triangles.size(), 1)),
        spacing(wanted),
        surface(surface_to_remesh(mesh, features, shape, spacing)),
        work{surface, shape, spacing, tolerance} {}

  SurfaceMesh mesh;
  SurfaceFeatures features;
  InputShape shape;
  RemeshingSpacing spacing;
  ChangingSurface surface;
  RemeshingWork work;
};

/// The volume that the triangles enclose.
inline double volume_of(const ChangingSurface& surface) {
  double volume = 0;
  for (std::int32_t t = 0; t < surface.triangle_end(); ++t) {
    if (!surface.is_there(t)) continue;
    const TrianglePoints c = surface.points(surface.triangle(t).nodes);
    volume += dot(c[0], cross(c[1], c[2])) / 6;
  }
  return volume;
}

}  // namespace tetfarm
