/// What generated surfaces are put together from.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "mesh/core/surface_mesh.h"

namespace tetfarm::shapes {

/// The four nodes round a quad, split from the first, or turned from the second.
inline void add_quad(SurfaceMesh& mesh, const std::array<std::int32_t, 4>& q, bool is_turned) {
  if (is_turned) {
    mesh.triangles.push_back({q[1], q[2], q[3]});
    mesh.triangles.push_back({q[1], q[3], q[0]});
  } else {
    mesh.triangles.push_back({q[0], q[1], q[2]});
    mesh.triangles.push_back({q[0], q[2], q[3]});
  }
}

/// All triangles in the patch "surface".
inline SurfaceMesh with_one_patch(SurfaceMesh mesh) {
  mesh.patch_of_triangle.assign(mesh.triangles.size(), 0);
  mesh.patch_names = {"surface"};
  return mesh;
}

}  // namespace tetfarm::shapes
