// Surfaces with flat patches: boxes with one for each side, and others by chance.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/array_index.h"
#include "mesh/core/surface_mesh.h"
#include "mesh/layers/layer_request.h"
#include "tests/support/chance.h"
#include "tests/support/shapes.h"

namespace tetfarm::test {

inline constexpr std::int32_t floor_patch = 0;
inline constexpr std::int32_t ceiling_patch = 1;

/// Patches: floor, ceiling, west, east, south, north.
inline SurfaceMesh box_with_patches(const Vec3& low, const Vec3& high, int n) {
  SurfaceMesh box = shapes::box(low, high, n);
  box.patch_of_triangle.clear();
  box.patch_names = {"floor", "ceiling", "west", "east", "south", "north"};
  for (const Triangle& triangle : box.triangles) {
    const auto all_at = [&](int axis, double place) {
      return std::all_of(triangle.begin(), triangle.end(),
                         [&](std::int32_t v) { return box.vertices[at(v)][axis] == place; });
    };
    std::int32_t patch = all_at(2, low.z) ? 0 : all_at(2, high.z) ? 1 : all_at(0, low.x) ? 2 : 3;
    if (all_at(1, low.y)) patch = 4;
    if (all_at(1, high.y)) patch = 5;
    box.patch_of_triangle.push_back(patch);
  }
  return box;
}

/// With its patches as groups.
inline std::string obj_of(const SurfaceMesh& surface) {
  std::ostringstream text;
  text.precision(17);
  for (const Vec3& p : surface.vertices) text << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
  for (std::size_t patch = 0; patch < surface.patch_names.size(); ++patch) {
    text << "g " << surface.patch_names[patch] << '\n';
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      if (surface.patch_of_triangle[t] != static_cast<std::int32_t>(patch)) continue;
      const auto& [a, b, c] = surface.triangles[t];
      text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
    }
  }
  return text.str();
}

/// About an oblique axis, so that no side keeps a coordinate.
inline SurfaceMesh turned(SurfaceMesh surface) {
  const Vec3 axis = normalized(Vec3{1, 2, 3});
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  for (Vec3& p : surface.vertices) {
    p = c * p + s * cross(axis, p) + (1 - c) * dot(axis, p) * axis;
  }
  return surface;
}

/// Patch 0, and by chance some flat pieces of the surface as patches of their own.
inline SurfaceMesh with_flat_patches(SurfaceMesh surface, std::uint64_t seed) {
  shapes::Chance chance(seed);
  std::map<std::array<std::int32_t, 2>, std::int32_t> across;
  const auto normal = [&](std::int32_t triangle) {
    const Triangle& t = surface.triangles[at(triangle)];
    const Vec3 a = surface.vertices[at(t[0])];
    return normalized(cross(surface.vertices[at(t[1])] - a, surface.vertices[at(t[2])] - a));
  };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      across[{surface.triangles[t][k], surface.triangles[t][(k + 1) % 3]}] =
          static_cast<std::int32_t>(t);
    }
  }
  surface.patch_names = {"wall"};
  surface.patch_of_triangle.assign(surface.triangles.size(), 0);
  const int pieces = chance.pick(1, 4);
  for (int piece = 0; piece < pieces; ++piece) {
    const std::int32_t seed_triangle =
        chance.pick(0, static_cast<int>(surface.triangles.size()) - 1);
    if (surface.patch_of_triangle[at(seed_triangle)] != 0) continue;
    const auto patch = static_cast<std::int32_t>(surface.patch_names.size());
    surface.patch_names.push_back("plane " + std::to_string(patch));
    std::vector<std::int32_t> reached = {seed_triangle};
    surface.patch_of_triangle[at(seed_triangle)] = patch;
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const Triangle& nodes = surface.triangles[at(reached[i])];
      for (std::size_t k = 0; k < 3; ++k) {
        const auto next = across.find({nodes[(k + 1) % 3], nodes[k]});
        if (next == across.end() || surface.patch_of_triangle[at(next->second)] != 0) continue;
        if (dot(normal(next->second), normal(seed_triangle)) < 1 - 1e-12) continue;
        surface.patch_of_triangle[at(next->second)] = patch;
        reached.push_back(next->second);
      }
    }
  }
  return surface;
}

/// From these patches.
inline LayerRequest request_of(std::vector<std::int32_t> patches, double first, int count) {
  LayerRequest request;
  request.law = {.first = first, .growth = 1.2, .acceleration = 1, .cap = 1.2, .equal = 1};
  request.count = count;
  request.patches = std::move(patches);
  return request;
}

}  // namespace tetfarm::test
