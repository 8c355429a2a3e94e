#include "tests/support/generated_skins.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "base/array_index.h"
#include "tests/support/chance.h"
#include "tests/support/surface_parts.h"

namespace tetfarm::shapes {
namespace {

/// The skin of the cells of an n x m x l grid that are in; diagonals by chance.
SurfaceMesh skin(const std::array<int, 3>& n, const std::vector<bool>& is_in, Chance& chance) {
  SurfaceMesh mesh;
  std::map<std::array<int, 3>, std::int32_t> number;
  const auto node = [&](const std::array<int, 3>& p) {
    const auto [it, is_new] = number.try_emplace(p, static_cast<std::int32_t>(number.size()));
    if (is_new) {
      mesh.vertices.push_back({double(p[0]), double(p[1]), double(p[2])});
    }
    return it->second;
  };
  const auto holds = [&](const std::array<int, 3>& c) {
    for (int k = 0; k < 3; ++k) {
      if (c[at(k)] < 0 || c[at(k)] >= n[at(k)]) return false;
    }
    return static_cast<bool>(is_in[at((c[0] * n[1] + c[1]) * n[2] + c[2])]);
  };
  for (int cell = 0; cell < n[0] * n[1] * n[2]; ++cell) {
    const std::array<int, 3> c = {cell / n[2] / n[1], cell / n[2] % n[1], cell % n[2]};
    if (!holds(c)) continue;
    for (int axis = 0; axis < 3; ++axis) {
      for (int side = 0; side < 2; ++side) {
        std::array<int, 3> beyond = c;
        beyond[at(axis)] += 2 * side - 1;
        if (holds(beyond)) continue;
        std::array<int, 3> p = c;
        p[at(axis)] += side;
        std::array<std::int32_t, 4> q{};
        for (int k = 0; k < 4; ++k) {
          std::array<int, 3> corner = p;
          corner[at((axis + 1) % 3)] += k == 1 || k == 2 ? 1 : 0;
          corner[at((axis + 2) % 3)] += k >= 2 ? 1 : 0;
          q[at(k)] = node(corner);
        }
        if (side == 0) std::swap(q[1], q[3]);
        add_quad(mesh, q, chance.coin());
      }
    }
  }
  return with_one_patch(mesh);
}

}  // namespace

SurfaceMesh voxels(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int n = chance.pick(2, 2 + size);
  std::vector<bool> is_in(at(n * n * n), false);
  // A walk, so that few cells touch along an edge only.
  std::array<int, 3> c = {n / 2, n / 2, n / 2};
  for (int step = chance.pick(2, 4 * n); step > 0; --step) {
    is_in[at((c[0] * n + c[1]) * n + c[2])] = true;
    int& x = c[at(chance.pick(0, 2))];
    x = std::clamp(x + (chance.coin() ? 1 : -1), 0, n - 1);
  }
  return skin({n, n, n}, is_in, chance);
}

SurfaceMesh handles(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int n = 2 * chance.pick(1, size == 1 ? 2 : 7) + 1,
            m = 2 * chance.pick(1, size == 1 ? 1 : 7) + 1;
  std::vector<bool> is_in;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) is_in.push_back(i % 2 == 0 || j % 2 == 0);
  }
  SurfaceMesh mesh = skin({n, m, 1}, is_in, chance);
  const double height = chance.coin() ? 1 : chance.small(-4, 1);
  for (Vec3& p : mesh.vertices) p.z *= height;
  return mesh;
}

SurfaceMesh grid(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int n = chance.pick(1, 2 * size + 1);
  SurfaceMesh mesh = skin({n, n, n}, std::vector<bool>(at(n * n * n), true), chance);
  if (chance.coin()) return mesh;
  for (Vec3& p : mesh.vertices) {
    if (p.z == n) p.z += 0.25 * chance.pick(0, 12);
  }
  return mesh;
}

SurfaceMesh cubes(std::uint64_t seed, int size) {
  Chance chance(seed);
  std::array<int, 3> n{};
  for (int& x : n) x = 2 * chance.pick(1, size) + 1;
  const int most_odd = chance.pick(1, 2);
  std::vector<bool> is_in;
  for (int cell = 0; cell < n[0] * n[1] * n[2]; ++cell) {
    const std::array<int, 3> c = {cell / n[2] / n[1], cell / n[2] % n[1], cell % n[2]};
    is_in.push_back(c[0] % 2 + c[1] % 2 + c[2] % 2 <= most_odd);
  }
  return skin(n, is_in, chance);
}

}  // namespace tetfarm::shapes
