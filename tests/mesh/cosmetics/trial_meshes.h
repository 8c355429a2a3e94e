/// Meshes for the tests and trials of cosmetics: boundary nodes first, then the inner ones.
#pragma once

#include <algorithm>
#include <map>

#include "mesh/geometry/bowyer_watson.h"
#include "tests/support/shapes.h"

namespace tetfarm::trial {

/// In [0, 1), the same for the same seed and number everywhere.
inline double random_unit(std::uint64_t seed, std::uint64_t number) {
  std::uint64_t x = seed * 0x9e3779b97f4a7c15ULL + number * 0xbf58476d1ce4e5b9ULL + 1;
  for (int i = 0; i < 3; ++i) {
    x ^= x >> 31;
    x *= 0x94d049bb133111ebULL;
  }
  return static_cast<double>(x >> 11) * 0x1p-53;
}

inline Vec3 random_vector(std::uint64_t seed, std::uint64_t number) {
  return {random_unit(seed, 3 * number) - 0.5, random_unit(seed, 3 * number + 1) - 0.5,
          random_unit(seed, 3 * number + 2) - 0.5};
}

/// [0, n]^3 in unit cubes of six tets; inner nodes are off by up to `jitter` / 2 along each axis.
inline TetMesh kuhn_box(int n, double jitter = 0, std::uint64_t seed = 1) {
  TetMesh mesh;
  std::map<std::array<int, 3>, std::int32_t> number;
  for (const bool inner : {false, true}) {
    for (int i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i) {
      const std::array<int, 3> p = {i % (n + 1), i / (n + 1) % (n + 1), i / (n + 1) / (n + 1)};
      const bool is_inner = std::all_of(p.begin(), p.end(), [n](int x) { return x > 0 && x < n; });
      if (is_inner != inner) continue;
      number[p] = static_cast<std::int32_t>(mesh.nodes.size());
      mesh.nodes.push_back({double(p[0]), double(p[1]), double(p[2])});
      if (inner) mesh.nodes.back() += jitter * random_vector(seed, std::uint64_t(i));
    }
    if (!inner) mesh.boundary_nodes = static_cast<std::int32_t>(mesh.nodes.size());
  }
  const std::array<std::array<int, 3>, 6> orders = {
      {{0, 1, 2}, {1, 0, 2}, {1, 2, 0}, {2, 1, 0}, {2, 0, 1}, {0, 2, 1}}};
  for (int i = 0; i < n * n * n; ++i) {
    for (std::size_t o = 0; o < 6; ++o) {
      std::array<int, 3> p = {i % n, i / n % n, i / n / n};
      Tet tet{};
      tet[0] = number[p];
      for (std::size_t step = 0; step < 3; ++step) {
        ++p[static_cast<std::size_t>(orders[o][step])];
        tet[step + 1] = number[p];
      }
      if (o % 2 == 1) std::swap(tet[0], tet[1]);
      mesh.tets.push_back(tet);
    }
  }
  return mesh;
}

/// A box of 2^3 cubes whose one inner node, number 26, lies at `inner` instead of (1, 1, 1).
inline TetComplex box_with_inner_node(const Vec3& inner) {
  TetMesh mesh = kuhn_box(2);
  mesh.nodes[26] = inner;
  return make_tet_complex(mesh);
}

/// The Delaunay tets of the points, without the far ones; nodes below `boundary_nodes` first.
inline TetMesh delaunay_mesh(const std::vector<Vec3>& points, std::int32_t boundary_nodes) {
  const DelaunayTets delaunay = bowyer_watson(points);
  TetMesh mesh;
  mesh.nodes = points;
  mesh.boundary_nodes = boundary_nodes;
  const auto last = static_cast<std::int32_t>(points.size());
  for (const Tet& tet : delaunay.complex.nodes) {
    if (tet[0] >= 0 && std::all_of(tet.begin(), tet.end(), [&](int v) { return v < last; })) {
      mesh.tets.push_back(tet);
    }
  }
  return mesh;
}

/// A ball of radius 1 with an icosphere of `levels` as its boundary and points of a body-centred
/// cubic lattice inside, `clearance` edge lengths from the boundary: as the mesher seeds a volume.
/// The edge length of the lattice fits that of the surface.
inline TetMesh lattice_ball(int levels, double clearance = 0.5) {
  std::vector<Vec3> points = shapes::sphere({0, 0, 0}, 1, levels).vertices;
  const auto boundary = static_cast<std::int32_t>(points.size());
  const double edge = std::sqrt(4 * 4 * 3.14159265 / std::sqrt(3.0) / (20 << (2 * levels)));
  const double cell = edge / 0.92;
  const int n = static_cast<int>(1 / cell) + 1;
  for (int i = -n; i <= n; ++i) {
    for (int j = -n; j <= n; ++j) {
      for (int k = -n; k <= n; ++k) {
        for (const double half : {0.0, 0.5}) {
          const Vec3 p{(i + half) * cell, (j + half) * cell, (k + half) * cell};
          if (norm(p) < 1 - clearance * edge) points.push_back(p);
        }
      }
    }
  }
  return delaunay_mesh(points, boundary);
}

/// The half of such a ball below z = 0, cut off by a flat disc: what a planar cut leaves. The rim
/// of the disc is as fine as the rest.
inline TetMesh lattice_half_ball(int rings) {
  const double edge = 1.0 / rings;
  std::vector<Vec3> points;
  for (const Vec3& p : shapes::sphere({0, 0, 0}, 1, 4).vertices) {
    if (rings == 14 && p.z < -0.5 * edge) points.push_back(p);
  }
  for (int ring = 0; ring <= rings; ++ring) {
    const int count = ring == 0 ? 1 : 6 * ring;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * 3.14159265358979 * (i + 0.5 * (ring % 2)) / count;
      points.push_back({ring * edge * std::cos(angle), ring * edge * std::sin(angle), 0});
    }
  }
  const auto boundary = static_cast<std::int32_t>(points.size());
  const double cell = edge / 0.92;
  for (int i = -rings; i <= rings; ++i) {
    for (int j = -rings; j <= rings; ++j) {
      for (int k = -rings; k <= rings; ++k) {
        for (const double half : {0.0, 0.5}) {
          const Vec3 p{(i + half) * cell, (j + half) * cell, (k + half) * cell};
          if (norm(p) < 1 - 0.5 * edge && p.z < -0.5 * edge) points.push_back(p);
        }
      }
    }
  }
  return delaunay_mesh(points, boundary);
}

/// A shell between spheres of radius 1 and 0.5 with edges of like length.
inline TetMesh lattice_shell(int levels) {
  std::vector<Vec3> points = shapes::sphere({0, 0, 0}, 1, levels).vertices;
  const auto outer = static_cast<std::int32_t>(points.size());
  for (const Vec3& p : shapes::sphere({0, 0, 0}, 0.5, levels - 1).vertices) points.push_back(p);
  const auto boundary = static_cast<std::int32_t>(points.size());
  const double edge = std::sqrt(4 * 4 * 3.14159265 / std::sqrt(3.0) / (20 << (2 * levels)));
  const double cell = edge / 0.92;
  const int n = static_cast<int>(1 / cell) + 1;
  for (int i = -n; i <= n; ++i) {
    for (int j = -n; j <= n; ++j) {
      for (int k = -n; k <= n; ++k) {
        for (const double half : {0.0, 0.5}) {
          const Vec3 p{(i + half) * cell, (j + half) * cell, (k + half) * cell};
          if (norm(p) < 1 - 0.5 * edge && norm(p) > 0.5 + 0.5 * edge) points.push_back(p);
        }
      }
    }
  }
  TetMesh mesh = delaunay_mesh(points, boundary);
  std::erase_if(mesh.tets, [&](const Tet& tet) {
    return std::all_of(tet.begin(), tet.end(), [&](int v) { return v >= outer && v < boundary; });
  });
  return mesh;
}

/// The same ball with points thrown at random: slivers everywhere.
inline TetMesh random_ball(int levels, int inner_points, std::uint64_t seed) {
  std::vector<Vec3> points = shapes::sphere({0, 0, 0}, 1, levels).vertices;
  const auto boundary = static_cast<std::int32_t>(points.size());
  const auto all = points.size() + static_cast<std::size_t>(inner_points);
  for (std::uint64_t i = 0; points.size() < all; ++i) {
    const Vec3 p = 2 * random_vector(seed, i);
    if (norm(p) < 0.9) points.push_back(p);
  }
  return delaunay_mesh(points, boundary);
}

}  // namespace tetfarm::trial
