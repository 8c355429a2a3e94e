#include "mesh/healing/vertex_welding.h"

#include <algorithm>

#include "base/check.h"
#include "base/disjoint_sets.h"
#include "mesh/geometry/box_tree.h"

namespace tetfarm {
namespace {

std::vector<std::int32_t> vertices_on_open_edges(std::span<const EdgeUse> uses) {
  std::vector<std::int32_t> found;
  for_each_edge(uses, [&found](std::span<const EdgeUse> edge) {
    if (edge.size() == 1) found.insert(found.end(), {edge[0].low, edge[0].high});
  });
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

void join_near(const HealingWork& work, const std::vector<std::int32_t>& vertices,
               DisjointSets& sets) {
  std::vector<Box3> boxes;
  const double half = 0.5 * work.tolerance;
  for (const std::int32_t v : vertices) {
    Box3 box;
    box.add(vertex_at(work.surface, v) - Vec3{half, half, half});
    box.add(vertex_at(work.surface, v) + Vec3{half, half, half});
    boxes.push_back(box);
  }
  BoxTree(boxes).self_pairs([&](std::int32_t i, std::int32_t j) {
    const std::int32_t a = vertices[static_cast<std::size_t>(i)];
    const std::int32_t b = vertices[static_cast<std::size_t>(j)];
    if (distance(vertex_at(work.surface, a), vertex_at(work.surface, b)) > work.tolerance) return;
    sets.join(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
  });
}

/// Each vertex with the lowest number of those that it is joined with.
std::vector<std::int32_t> lowest_of_sets(DisjointSets& sets, std::size_t count) {
  std::vector<std::int32_t> lowest(count, -1);
  std::vector<std::int32_t> into(count);
  for (std::size_t v = 0; v < count; ++v) {
    std::int32_t& first = lowest[sets.root(v)];
    if (first < 0) first = static_cast<std::int32_t>(v);
    into[v] = first;
  }
  return into;
}

}  // namespace

std::int64_t weld_vertices(HealingWork& work, const std::vector<char>& is_bad) {
  SurfaceMesh& surface = work.surface;
  TF_CHECK(is_bad.size() == surface.triangles.size());
  DisjointSets sets(surface.vertices.size());
  const std::vector<EdgeUse> uses = edge_uses(surface.triangles);
  for (const EdgeUse& use : uses) {
    const bool is_short =
        distance(vertex_at(surface, use.low), vertex_at(surface, use.high)) <= work.tolerance;
    if (is_short && is_bad[static_cast<std::size_t>(use.triangle)] != 0) {
      sets.join(static_cast<std::size_t>(use.low), static_cast<std::size_t>(use.high));
    }
  }
  join_near(work, vertices_on_open_edges(uses), sets);
  const std::vector<std::int32_t> into = lowest_of_sets(sets, surface.vertices.size());
  std::int64_t gone = 0;
  for (std::size_t v = 0; v < into.size(); ++v) {
    if (into[v] == static_cast<std::int32_t>(v)) continue;
    work.acts.push_back({HealKind::joined, surface.vertices[v], {}});
    ++gone;
  }
  if (gone == 0) return 0;
  std::vector<char> has_lost_side(surface.triangles.size(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    Triangle& n = surface.triangles[t];
    for (std::int32_t& v : n) v = into[static_cast<std::size_t>(v)];
    has_lost_side[t] = n[0] == n[1] || n[1] == n[2] || n[2] == n[0] ? 1 : 0;
  }
  remove_triangles(surface, has_lost_side);
  return gone;
}

}  // namespace tetfarm
