#include "mesh/inspect/vertex_fans.h"

#include "base/disjoint_sets.h"

namespace tetfarm {
namespace {

/// The number of a corner among those of all triangles: 3 · triangle + corner.
std::size_t corner_at(const SurfaceMesh& surface, std::int32_t triangle, std::int32_t v) {
  const auto t = static_cast<std::size_t>(triangle);
  const Triangle& nodes = surface.triangles[t];
  return 3 * t + (nodes[0] == v ? 0U : nodes[1] == v ? 1U : 2U);
}

}  // namespace

std::vector<std::int32_t> vertices_of_several_fans(const SurfaceMesh& surface,
                                                   std::span<const EdgeUse> uses) {
  DisjointSets fans(3 * surface.triangles.size());
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    for (const EdgeUse& use : edge.subspan(1)) {
      for (const std::int32_t v : {use.low, use.high}) {
        fans.join(corner_at(surface, edge[0].triangle, v), corner_at(surface, use.triangle, v));
      }
    }
  });
  constexpr std::size_t none = ~std::size_t{0};
  std::vector<std::size_t> fan(surface.vertices.size(), none);
  std::vector<char> several(surface.vertices.size(), 0);
  for (const EdgeUse& use : uses) {
    for (const std::int32_t v : {use.low, use.high}) {
      const std::size_t root = fans.root(corner_at(surface, use.triangle, v));
      std::size_t& first = fan[static_cast<std::size_t>(v)];
      if (first == none) first = root;
      if (first != root) several[static_cast<std::size_t>(v)] = 1;
    }
  }
  std::vector<std::int32_t> result;
  for (std::size_t v = 0; v < several.size(); ++v) {
    if (several[v] != 0) result.push_back(static_cast<std::int32_t>(v));
  }
  return result;
}

}  // namespace tetfarm
