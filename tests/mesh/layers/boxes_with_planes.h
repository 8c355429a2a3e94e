// Boxes with a patch for each side.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/array_index.h"
#include "mesh/core/surface_mesh.h"
#include "mesh/layers/layer_request.h"
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
      return std::all_of(triangle.begin(), triangle.end(), [&](std::int32_t v) {
        return box.vertices[at(v)][axis] == place;
      });
    };
    std::int32_t patch = all_at(2, low.z) ? 0 : all_at(2, high.z) ? 1 : all_at(0, low.x) ? 2 : 3;
    if (all_at(1, low.y)) patch = 4;
    if (all_at(1, high.y)) patch = 5;
    box.patch_of_triangle.push_back(patch);
  }
  return box;
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

/// From these patches.
inline LayerRequest request_of(std::vector<std::int32_t> patches, double first, int count) {
  LayerRequest request;
  request.law = {.first = first, .growth = 1.2, .acceleration = 1, .cap = 1.2, .equal = 1};
  request.count = count;
  request.patches = std::move(patches);
  return request;
}

}  // namespace tetfarm::test
