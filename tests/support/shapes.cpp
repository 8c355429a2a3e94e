#include "tests/support/shapes.h"

#include <algorithm>
#include <map>
#include <numbers>

namespace tetfarm::shapes {
namespace {

void finish(SurfaceMesh& mesh) {
  mesh.patch_of_triangle.assign(mesh.triangles.size(), 0);
  mesh.patch_names = {"surface"};
}

}  // namespace

SurfaceMesh tetrahedron() {
  SurfaceMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  finish(mesh);
  return mesh;
}

SurfaceMesh unit_cube() { return box({0, 0, 0}, {1, 1, 1}, 1); }

SurfaceMesh box(const Vec3& low, const Vec3& high, int n) {
  SurfaceMesh mesh;
  std::map<std::array<int, 3>, std::int32_t> number;
  const Vec3 size = high - low;
  const auto node = [&](std::array<int, 3> ijk) {
    const auto [it, is_new] =
        number.try_emplace(ijk, static_cast<std::int32_t>(mesh.vertices.size()));
    if (is_new) {
      mesh.vertices.push_back(
          {low.x + size.x * ijk[0] / n, low.y + size.y * ijk[1] / n, low.z + size.z * ijk[2] / n});
    }
    return it->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (int side = 0; side < 2; ++side) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          std::array<std::array<int, 3>, 4> corner{};
          for (int k = 0; k < 4; ++k) {
            auto& c = corner[static_cast<std::size_t>(k)];
            c[static_cast<std::size_t>(axis)] = side * n;
            c[static_cast<std::size_t>(u)] = i + (k == 1 || k == 2 ? 1 : 0);
            c[static_cast<std::size_t>(v)] = j + (k >= 2 ? 1 : 0);
          }
          std::array<std::int32_t, 4> q{node(corner[0]), node(corner[1]), node(corner[2]),
                                        node(corner[3])};
          if (side == 0) std::swap(q[1], q[3]);
          mesh.triangles.push_back({q[0], q[1], q[2]});
          mesh.triangles.push_back({q[0], q[2], q[3]});
        }
      }
    }
  }
  finish(mesh);
  return mesh;
}

SurfaceMesh sphere(const Vec3& centre, double radius, int levels) {
  const double g = std::numbers::phi;
  std::vector<Vec3> unit = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                            {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                            {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  std::vector<Triangle> triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                     {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                     {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                     {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::array<std::int32_t, 2>, std::int32_t> middle;
    const auto mid = [&](std::int32_t a, std::int32_t b) {
      const auto [it, is_new] = middle.try_emplace({std::min(a, b), std::max(a, b)},
                                                   static_cast<std::int32_t>(unit.size()));
      if (is_new) {
        unit.push_back(0.5 *
                       (unit[static_cast<std::size_t>(a)] + unit[static_cast<std::size_t>(b)]));
      }
      return it->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : triangles) {
      const std::int32_t ab = mid(a, b);
      const std::int32_t bc = mid(b, c);
      const std::int32_t ca = mid(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
    for (Vec3& p : unit) p = normalized(p);
  }
  SurfaceMesh mesh;
  for (const Vec3& p : unit) mesh.vertices.push_back(centre + radius * normalized(p));
  mesh.triangles = std::move(triangles);
  finish(mesh);
  return mesh;
}

SurfaceMesh between(const SurfaceMesh& outer, const SurfaceMesh& inner) {
  SurfaceMesh mesh = outer;
  const auto offset = static_cast<std::int32_t>(outer.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), inner.vertices.begin(), inner.vertices.end());
  for (const auto& [a, b, c] : inner.triangles) {
    mesh.triangles.push_back({a + offset, c + offset, b + offset});
  }
  finish(mesh);
  return mesh;
}

SurfaceMesh nested_spheres(int levels) {
  return between(sphere({0, 0, 0}, 1.0, levels), sphere({0, 0, 0}, 0.4, levels));
}

SurfaceMesh torus(double minor, int n, int m) {
  SurfaceMesh mesh;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      const double u = 2 * std::numbers::pi * i / n;
      const double v = 2 * std::numbers::pi * j / m;
      const double r = 1 + minor * std::cos(v);
      mesh.vertices.push_back({r * std::cos(u), r * std::sin(u), minor * std::sin(v)});
    }
  }
  const auto node = [&](int i, int j) { return static_cast<std::int32_t>((i % n) * m + j % m); };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      mesh.triangles.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1)});
      mesh.triangles.push_back({node(i, j), node(i + 1, j + 1), node(i, j + 1)});
    }
  }
  finish(mesh);
  return mesh;
}

}  // namespace tetfarm::shapes
