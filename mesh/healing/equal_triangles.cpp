#include "mesh/healing/equal_triangles.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace tetfarm {
namespace {

Triangle sorted(Triangle nodes) {
  std::ranges::sort(nodes);
  return nodes;
}

/// Whether the edges of equal triangles are closed by the others on them.
bool is_fold(std::span<const EdgeUse> uses, const Triangle& nodes, std::size_t copies) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t others = uses_of_edge(uses, nodes[k], nodes[(k + 1) % 3]).size() - copies;
    if (others % 2 != 0) return false;
  }
  return true;
}

}  // namespace

std::int64_t remove_equal_triangles(HealingWork& work) {
  SurfaceMesh& surface = work.surface;
  std::vector<std::size_t> order(surface.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto corners = [&surface](std::size_t t) { return sorted(surface.triangles[t]); };
  std::ranges::stable_sort(order, {}, corners);
  const std::vector<EdgeUse> uses = edge_uses(surface.triangles);
  std::vector<char> is_gone(surface.triangles.size(), 0);
  std::int64_t gone = 0;
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first + 1;
    while (end < order.size() && corners(order[end]) == corners(order[first])) ++end;
    const std::size_t copies = end - first;
    if (copies > 1) {
      const bool all_go = is_fold(uses, surface.triangles[order[first]], copies);
      for (std::size_t i = all_go ? first : first + 1; i < end; ++i) {
        is_gone[order[i]] = 1;
        ++gone;
      }
      const TrianglePoints points = points_of(surface, order[first]);
      work.acts.push_back({all_go ? HealKind::fold : HealKind::duplicate, points[0], {points}});
    }
    first = end;
  }
  remove_triangles(surface, is_gone);
  return gone;
}

}  // namespace tetfarm
