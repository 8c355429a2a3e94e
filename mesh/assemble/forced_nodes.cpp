#include "mesh/assemble/forced_nodes.h"

#include <algorithm>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/assemble/forced_dihedral.h"
#include "mesh/core/triangle_angles.h"

namespace tetfarm {
namespace {

/// Of each region, by its number, the triangles that bound it, turned to point out of it.
std::vector<std::vector<Triangle>> boundaries_of_regions(const SurfaceMesh& surface) {
  std::vector<std::vector<Triangle>> boundaries(at(region_count(surface)) + 1);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    const auto [behind, front] = sides_of(surface, t);
    if (behind > 0) boundaries[at(behind)].push_back({a, b, c});
    if (front > 0 && front != behind) boundaries[at(front)].push_back({a, c, b});
  }
  return boundaries;
}

/// Ascending.
std::vector<std::int32_t> forced_vertices(const std::vector<Vec3>& vertices,
                                          const std::vector<Triangle>& boundary) {
  const auto place = [&vertices](std::int32_t v) -> const Vec3& { return vertices[at(v)]; };
  std::vector<std::int32_t> forced;
  for (const auto& [a, b, c] : boundary) {
    if (smallest_angle_deg(place(a), place(b), place(c)) >= forcing_deg) continue;
    forced.insert(forced.end(), {a, b, c});
  }
  for_each_edge_of_two(boundary, [&](const EdgeOfTwo& edge) {
    const double bound =
        forced_dihedral_at_edge(place(edge.u), place(edge.v), place(edge.left), place(edge.right));
    if (bound < forcing_deg) forced.insert(forced.end(), {edge.u, edge.v});
  });
  std::sort(forced.begin(), forced.end());
  forced.erase(std::unique(forced.begin(), forced.end()), forced.end());
  return forced;
}

}  // namespace

std::vector<ForcedNode> forced_nodes(const SurfaceMesh& surface) {
  TF_CHECK(surface.sides.empty() || surface.sides.size() == surface.triangles.size());
  std::vector<std::vector<Triangle>> boundaries = boundaries_of_regions(surface);
  std::vector<ForcedNode> forced;
  for (std::size_t region = 1; region < boundaries.size(); ++region) {
    const std::vector<Triangle> boundary = std::exchange(boundaries[region], {});
    for (const std::int32_t vertex : forced_vertices(surface.vertices, boundary)) {
      forced.push_back({vertex, static_cast<std::int32_t>(region)});
    }
  }
  std::sort(forced.begin(), forced.end());
  return forced;
}

}  // namespace tetfarm
