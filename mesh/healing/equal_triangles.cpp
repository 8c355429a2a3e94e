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

/// Whether the edges of a triangle are closed by the others on them, each of which counts once.
bool is_fold(std::span<const EdgeUse> single_uses, const Triangle& nodes) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto uses = uses_of_edge(single_uses, nodes[k], nodes[(k + 1) % 3]);
    if ((uses.size() - 1) % 2 != 0) return false;
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
  // Of equal ones, all but the first.
  std::vector<char> is_gone(surface.triangles.size(), 0);
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (corners(order[i]) == corners(order[i - 1])) is_gone[order[i]] = 1;
  }
  std::vector<char> is_single(is_gone.size());
  std::ranges::transform(is_gone, is_single.begin(), [](char gone) { return gone == 0 ? 1 : 0; });
  const std::vector<EdgeUse> single_uses = edge_uses(surface.triangles, is_single);
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    const std::size_t first = order[i];
    if (is_gone[first] != 0 || is_gone[order[i + 1]] == 0) continue;
    const bool all_go = is_fold(single_uses, surface.triangles[first]);
    const TrianglePoints points = points_of(surface, first);
    work.acts.push_back({all_go ? HealKind::fold : HealKind::duplicate, points[0], {points}});
    if (all_go) is_gone[first] = 1;
  }
  const auto gone = std::ranges::count(is_gone, 1);
  remove_triangles(surface, is_gone);
  return gone;
}

}  // namespace tetfarm
