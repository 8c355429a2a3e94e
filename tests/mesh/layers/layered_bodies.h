// Bodies with sharp edges in a box, for layers that fan round them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "base/array_index.h"
#include "mesh/core/surface_mesh.h"
#include "mesh/core/vec3.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/layers/layer_plan.h"
#include "mesh/layers/layer_request.h"
#include "mesh/layers/plane_retreat.h"
#include "tests/mesh/layers/boxes_with_planes.h"
#include "tests/support/shapes.h"
#include "tests/support/voxel_surface.h"

namespace tetfarm::test {

inline constexpr std::int32_t body_patch = 0;

/// The space between a body, which is turned outwards, and a box that is three times as large.
inline SurfaceMesh in_a_box(const SurfaceMesh& body) {
  SurfaceMesh domain;
  domain.vertices = body.vertices;
  domain.triangles = body.triangles;
  domain.patch_names = {"body", "box"};
  domain.patch_of_triangle.assign(body.triangles.size(), body_patch);
  for (Triangle& t : domain.triangles) std::swap(t[1], t[2]);
  Box3 round;
  for (const Vec3& p : body.vertices) round.add(p);
  const Vec3 size = round.high - round.low;
  const SurfaceMesh box = shapes::box(round.low - size, round.high + size, 4);
  const auto first = static_cast<std::int32_t>(domain.vertices.size());
  domain.vertices.insert(domain.vertices.end(), box.vertices.begin(), box.vertices.end());
  for (const auto& [a, b, c] : box.triangles) {
    domain.triangles.push_back({a + first, b + first, c + first});
    domain.patch_of_triangle.push_back(1);
  }
  return domain;
}

inline SurfaceMesh cube_in_box(int n) { return in_a_box(shapes::box({-1, -1, -1}, {1, 1, 1}, n)); }

/// A wing of chord 2 and span 2 with a section like a lens, whose edges have so many degrees within
/// the body in the south and in the north.
inline SurfaceMesh lens_in_box(int n, double south, double north) {
  SurfaceMesh body = shapes::box({-1, -1, -1}, {1, 1, 1}, n);
  for (Vec3& p : body.vertices) {
    const double degrees = south + 0.5 * (p.y + 1) * (north - south);
    p.z *= 1e-9 + std::tan(0.5 * degrees * 3.14159265358979 / 180) * (1 - std::abs(p.x));
  }
  std::vector<std::int32_t> at_edge(body.vertices.size(), -1);
  // The sides at x = -1 and 1 are edges now.
  for (std::size_t v = 0; v < body.vertices.size(); ++v) {
    const Vec3& p = body.vertices[v];
    if (std::abs(p.x) < 1) continue;
    for (std::size_t w = 0; w <= v && at_edge[v] < 0; ++w) {
      const Vec3& q = body.vertices[w];
      if (q.x == p.x && q.y == p.y) at_edge[v] = static_cast<std::int32_t>(w);
    }
  }
  std::vector<Triangle> kept;
  for (Triangle t : body.triangles) {
    for (std::int32_t& v : t) v = at_edge[at(v)] >= 0 ? at_edge[at(v)] : v;
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) kept.push_back(t);
  }
  body.triangles = std::move(kept);
  for (std::size_t v = 0; v < body.vertices.size(); ++v) {
    if (std::abs(body.vertices[v].x) == 1) body.vertices[v].z = 0;
  }
  std::vector<std::int32_t> number(body.vertices.size(), -1);
  SurfaceMesh lens;
  for (Triangle t : body.triangles) {
    for (std::int32_t& v : t) {
      if (number[at(v)] < 0) {
        number[at(v)] = static_cast<std::int32_t>(lens.vertices.size());
        lens.vertices.push_back(body.vertices[at(v)]);
      }
      v = number[at(v)];
    }
    lens.triangles.push_back(t);
  }
  return in_a_box(lens);
}

/// A pillar on a block; seen from above both are rhombs whose sharp edges have 4 degrees, so that
/// those of the pillar end at the block.
inline SurfaceMesh fin_in_box() {
  const auto is_body = [](int x, int y, int z) {
    return z < 2 || (std::min(x, y) >= 2 && std::max(x, y) < 6) ? 1 : 0;
  };
  const shapes::VoxelSurface voxels = shapes::voxel_surface({{8, 8, 6}, is_body});
  SurfaceMesh body = voxels.surface;
  for (std::size_t t = 0; t < body.triangles.size(); ++t) {
    if (voxels.sets[t][0] == 0) std::swap(body.triangles[t][1], body.triangles[t][2]);
  }
  const double squeeze = std::tan(2 * 3.14159265358979 / 180);
  for (Vec3& p : body.vertices) p = {p.x - p.y, squeeze * (p.x + p.y - 8), p.z};
  return in_a_box(body);
}

/// A body with layers that fan round its edges.
struct LayeredBody {
  SurfaceMesh surface;
  LayerPlan plan;

  LayeredBody(SurfaceMesh domain, const LayerRequest& request)
      : surface(std::move(domain)), plan(plan_layers(surface, {&request, 1})) {}
};

/// A pillar of edge 2 on the middle of the floor of a box, with the patches "body", "floor" and
/// "rest".
inline SurfaceMesh pillar_in_box() {
  const auto is_domain = [](int x, int y, int z) {
    return z < 4 && std::min(x, y) >= 4 && std::max(x, y) < 8 ? 0 : 1;
  };
  const shapes::VoxelSurface voxels = shapes::voxel_surface({{12, 12, 10}, is_domain});
  SurfaceMesh domain;
  domain.vertices = voxels.surface.vertices;
  domain.triangles = voxels.surface.triangles;
  domain.patch_names = {"body", "floor", "rest"};
  for (std::size_t t = 0; t < domain.triangles.size(); ++t) {
    Triangle& nodes = domain.triangles[t];
    if (voxels.sets[t][0] == 0) std::swap(nodes[1], nodes[2]);
    Box3 round;
    for (const std::int32_t v : nodes) round.add(domain.vertices[at(v)]);
    const bool is_body = round.low.z <= 4 && round.low.x >= 4 && round.low.y >= 4 &&
                         round.high.x <= 8 && round.high.y <= 8 && round.high.z > 0;
    domain.patch_of_triangle.push_back(is_body ? body_patch : round.high.z == 0 ? 1 : 2);
  }
  for (Vec3& p : domain.vertices) p = 0.5 * p;
  return domain;
}

/// Layers from the body with several lines at edges of more than so many degrees.
inline LayerRequest fanned(double first, int count, double degrees) {
  LayerRequest request = request_of({body_patch}, first, count);
  request.fan_cosine = std::cos(degrees * 3.14159265358979 / 180);
  return request;
}

/// The pillar with layers that run in the floor, round its edges too.
struct LayeredPillar {
  SurfaceMesh surface;
  LayerPlan plan;

  explicit LayeredPillar(int count = 5, bool in_tets = false) {
    const SurfaceMesh pillar = pillar_in_box();
    LayerRequest request = fanned(0.02, count, 60);
    request.in_tets = in_tets;
    std::optional<PlaneRetreat> retreat =
        retreat_planes(pillar, plan_layers(pillar, {&request, 1}),
                       [](const SurfaceMesh&) { return [](const Vec3&) { return 0.5; }; });
    surface = std::move(retreat.value().surface);
    plan = std::move(retreat.value().plan);
  }
};

}  // namespace tetfarm::test
