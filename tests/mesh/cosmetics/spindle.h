/// Tets round one edge: what the swaps of edges and faces are tried on.
#pragma once

#include <cmath>

#include "base/array_index.h"
#include "mesh/core/tet_complex.h"

namespace tetfarm::cosmetics {

/// Nodes 0 and 1 far apart on the z axis, n ring nodes round it: n tets on the edge 0-1.
inline TetMesh spindle(int n, double half_height) {
  TetMesh mesh;
  mesh.nodes = {{0, 0, -half_height}, {0, 0, half_height}};
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979 * i / n;
    mesh.nodes.push_back({std::cos(angle), std::sin(angle), 0});
    mesh.tets.push_back({0, 1, 2 + i, 2 + (i + 1) % n});
  }
  mesh.boundary_nodes = n + 2;
  return mesh;
}

inline double volume(const TetComplex& complex) {
  double sum = 0;
  for (const Tet& tet : complex.nodes) {
    if (tet[0] < 0) continue;
    sum += tet_volume(complex.points[at(tet[0])], complex.points[at(tet[1])],
                      complex.points[at(tet[2])], complex.points[at(tet[3])]);
  }
  return sum;
}

}  // namespace tetfarm::cosmetics
