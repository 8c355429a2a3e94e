/// A small mesh of the plane with all that a file may hold: a square with a square hole, two
/// regions, patches with and without names, an edge inside.
#pragma once

#include "mesh/planar/plane_mesh.h"

namespace tetfarm {

/// Eight triangles, area 8: nodes 0 to 3 are the corners of [0, 3]², 4 to 7 those of [1, 2]².
/// Patches: 3 the lower outer edge ("inlet"), 5 the others of the outer border, 9 the hole
/// ("body").
inline PlaneMesh square_ring() {
  PlaneMesh mesh;
  mesh.name = "ring";
  mesh.points = {{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {2, 1}, {2, 2}, {1, 2}};
  mesh.triangles = {{0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5},
                    {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  mesh.regions = {1, 1, 1, 1, 2, 2, 2, 2};
  mesh.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {2, 6}};
  mesh.patches = {3, 5, 5, 5, 9, 9, 9, 9, 11};
  mesh.corners = {0, 2};
  mesh.patch_names = {{3, "inlet"}, {9, "the body"}};
  mesh.region_names = {{2, "upper"}};
  return mesh;
}

}  // namespace tetfarm
