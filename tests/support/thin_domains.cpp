#include "tests/support/thin_domains.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/shapes.h"

namespace tetfarm::shapes {
namespace {

void finish(SurfaceMesh& mesh) {
  mesh.patch_of_triangle.assign(mesh.triangles.size(), 0);
  mesh.patch_names = {"surface"};
}

std::int32_t count(const SurfaceMesh& mesh) {
  return static_cast<std::int32_t>(mesh.vertices.size());
}

void append(SurfaceMesh& mesh, const SurfaceMesh& other) {
  const std::int32_t first = count(mesh);
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.triangles) {
    mesh.triangles.push_back({a + first, b + first, c + first});
  }
}

}  // namespace

SurfaceMesh thin_wing(double thickness, int n) {
  constexpr double span = 4;
  constexpr double sweep = 0.7;
  const int m = 4 * n;
  SurfaceMesh mesh;
  const auto is_rim = [&](int i, int j) { return i == 0 || i == n || j == 0 || j == m; };
  const auto height = [&](int i, int j) {
    const double u = static_cast<double>(i) / n;
    const double v = static_cast<double>(j) / m;
    return 8 * thickness * u * (1 - u) * v * (1 - v);
  };
  const auto place = [&](int i, int j, double side) -> Vec3 {
    const double y = span * j / m;
    return {static_cast<double>(i) / n + sweep * y, y, side * height(i, j)};
  };
  const auto node = [&](int i, int j) { return static_cast<std::int32_t>(j * (n + 1) + i); };
  for (int j = 0; j <= m; ++j) {
    for (int i = 0; i <= n; ++i) mesh.vertices.push_back(place(i, j, 1));
  }
  std::vector<std::int32_t> below(mesh.vertices.size());
  for (int j = 0; j <= m; ++j) {
    for (int i = 0; i <= n; ++i) {
      const auto v = static_cast<std::size_t>(node(i, j));
      below[v] = is_rim(i, j) ? node(i, j) : count(mesh);
      if (!is_rim(i, j)) mesh.vertices.push_back(place(i, j, -1));
    }
  }
  const auto under = [&](std::int32_t v) { return below[static_cast<std::size_t>(v)]; };
  for (int j = 0; j < m; ++j) {
    for (int i = 0; i < n; ++i) {
      // The diagonal cuts no corner of the rim off, which would leave two faces on each other.
      const bool falls = (i == 0 && j == m - 1) || (i == n - 1 && j == 0);
      const std::int32_t a = node(i, j), b = node(i + 1, j), c = node(i + 1, j + 1),
                         d = node(i, j + 1);
      const Triangle first = falls ? Triangle{a, b, d} : Triangle{a, b, c};
      const Triangle second = falls ? Triangle{b, c, d} : Triangle{a, c, d};
      for (const Triangle& t : {first, second}) {
        mesh.triangles.push_back(t);
        mesh.triangles.push_back({under(t[0]), under(t[2]), under(t[1])});
      }
    }
  }
  finish(mesh);
  return mesh;
}

SurfaceMesh spiral(int turns, int n) {
  constexpr double minor = 0.05;
  constexpr double rise = 0.5;
  const double edge = 2 * std::numbers::pi * minor / n;
  const int rings = static_cast<int>(2 * std::numbers::pi * turns / edge);
  SurfaceMesh mesh;
  for (int i = 0; i <= rings; ++i) {
    const double u = 2 * std::numbers::pi * turns * i / rings;
    for (int j = 0; j < n; ++j) {
      const double v = 2 * std::numbers::pi * (j + 0.5 * (i % 2)) / n;
      const double r = 1 + minor * std::cos(v);
      mesh.vertices.push_back({r * std::cos(u), r * std::sin(u),
                               rise * u / (2 * std::numbers::pi) + minor * std::sin(v)});
    }
  }
  const auto node = [&](int i, int j) { return static_cast<std::int32_t>(i * n + j % n); };
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < n; ++j) {
      const std::int32_t a = node(i, j), b = node(i + 1, j), c = node(i + 1, j + 1),
                         d = node(i, j + 1);
      if (i % 2 == 0) {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({b, c, d});
      } else {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      }
    }
  }
  for (const int end : {0, rings}) {
    Vec3 centre{};
    for (int j = 0; j < n; ++j)
      centre = centre + mesh.vertices[static_cast<std::size_t>(node(end, j))];
    mesh.vertices.push_back(centre / n);
    for (int j = 0; j < n; ++j) {
      const std::int32_t a = node(end, j), b = node(end, j + 1);
      mesh.triangles.push_back(end == 0 ? Triangle{count(mesh) - 1, a, b}
                                        : Triangle{count(mesh) - 1, b, a});
    }
  }
  finish(mesh);
  return mesh;
}

SurfaceMesh thin_shell(double thickness, int levels) {
  return between(sphere({}, 1 + thickness, levels), sphere({}, 1, levels));
}

SurfaceMesh scattered_bodies(int n) {
  SurfaceMesh mesh;
  std::uint64_t state = 1;
  const auto by_chance = [&state] {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return 0.3 * (static_cast<double>(state >> 11U) / 9007199254740992.0 - 0.5);
  };
  for (int i = 0; i < n * n * n; ++i) {
    const double x = i % n + by_chance();
    const double y = i / n % n + by_chance();
    const double z = i / n / n + by_chance();
    append(mesh, sphere({x, y, z}, 0.1, 1));
  }
  finish(mesh);
  return mesh;
}

SurfaceMesh in_large_box(const SurfaceMesh& bodies, double factor, int n) {
  const Box3 tight = bounding_box(bodies.vertices);
  const Vec3 size = tight.size();
  const double half = 0.5 * factor * std::max({size.x, size.y, size.z});
  const Vec3 centre = 0.5 * (tight.low + tight.high);
  return between(box(centre - Vec3{half, half, half}, centre + Vec3{half, half, half}, n), bodies);
}

}  // namespace tetfarm::shapes
