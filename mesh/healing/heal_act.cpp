#include "mesh/healing/heal_act.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace tetfarm {

void add_triangle(SurfaceMesh& surface, const Triangle& nodes, std::int32_t patch) {
  const bool has_patches =
      surface.patch_of_triangle.size() == surface.triangles.size() && !surface.triangles.empty();
  surface.triangles.push_back(nodes);
  if (has_patches) surface.patch_of_triangle.push_back(patch);
}

void add_triangles(SurfaceMesh& surface, std::span<const Triangle> made, std::int32_t patch,
                   HealAct& act) {
  for (const Triangle& nodes : made) {
    act.triangles.push_back(triangle_points(surface.vertices, nodes));
    add_triangle(surface, nodes, patch);
  }
}

void remove_triangles(SurfaceMesh& surface, const std::vector<char>& is_gone) {
  TF_CHECK(is_gone.size() == surface.triangles.size());
  const bool has_patches = !surface.patch_of_triangle.empty();
  std::size_t kept = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (is_gone[t] != 0) continue;
    surface.triangles[kept] = surface.triangles[t];
    if (has_patches) surface.patch_of_triangle[kept] = surface.patch_of_triangle[t];
    ++kept;
  }
  surface.triangles.resize(kept);
  if (has_patches) surface.patch_of_triangle.resize(kept);
}

std::span<const EdgeUse> uses_of_edge(std::span<const EdgeUse> uses, std::int32_t a,
                                      std::int32_t b) {
  const auto edge = std::pair(std::min(a, b), std::max(a, b));
  const auto edge_of = [](const EdgeUse& use) { return std::pair(use.low, use.high); };
  const auto first = std::ranges::lower_bound(uses, edge, {}, edge_of);
  const auto end = std::ranges::upper_bound(uses, edge, {}, edge_of);
  return uses.subspan(static_cast<std::size_t>(first - uses.begin()),
                      static_cast<std::size_t>(end - first));
}

}  // namespace tetfarm
