/// Delaunay tets of points by chance, to change by flips.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "mesh/geometry/bowyer_watson.h"
#include "mesh/recovery/local_remeshing.h"

namespace tetfarm {

struct RandomTets {
  /// In the unit cube; the four nodes that come after the points enclose them.
  RandomTets(std::size_t points, std::uint64_t seed)
      : complex(bowyer_watson(random_points(points, seed)).complex), mesh(complex, constrained) {}

  static std::vector<Vec3> random_points(std::size_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto coordinate = [&random] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
    std::vector<Vec3> points(count);
    for (Vec3& p : points) {
      for (int axis = 0; axis < 3; ++axis) p[axis] = coordinate();
    }
    return points;
  }

  TetComplex complex;
  std::vector<std::uint8_t> constrained;
  LocalRemeshing mesh;
};

inline double volume_of(const TetComplex& complex) {
  double sum = 0;
  for (const Tet& tet : complex.nodes) {
    if (tet[0] < 0) continue;
    const auto point = [&](std::size_t i) {
      return complex.points[static_cast<std::size_t>(tet[i])];
    };
    sum += tet_volume(point(0), point(1), point(2), point(3));
  }
  return sum;
}

/// n tets round the edge of the nodes 0 and 1, which is on the z axis; the others turn round it.
inline TetComplex tets_round_an_edge(std::int32_t n, double half_height) {
  TetMesh mesh;
  mesh.nodes = {{0, 0, -half_height}, {0, 0, half_height}};
  for (std::int32_t i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979 * i / n;
    mesh.nodes.push_back({std::cos(angle), std::sin(angle), 0});
    mesh.tets.push_back({0, 1, 2 + i, 2 + (i + 1) % n});
  }
  mesh.boundary_nodes = n + 2;
  return make_tet_complex(mesh);
}

}  // namespace tetfarm
