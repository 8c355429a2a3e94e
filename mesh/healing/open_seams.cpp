#include "mesh/healing/open_seams.h"

#include <algorithm>
#include <span>
#include <utility>

#include "mesh/geometry/box_tree.h"

namespace tetfarm {
namespace {

Box3 point_box(const Vec3& p) {
  Box3 box;
  box.add(p);
  return box;
}

struct OnEdge {
  double share = 0;  ///< from low to high
  std::int32_t vertex = 0;
};

/// The place of p along the edge where it lies on it, away from its ends; otherwise less than 0.
double share_on_edge(const Vec3& low, const Vec3& high, const Vec3& p, double tolerance) {
  const Vec3 along = high - low;
  const double length2 = norm2(along);
  if (!(length2 > 4 * tolerance * tolerance)) return -1;
  const double share = dot(p - low, along) / length2;
  const Vec3 foot = low + share * along;
  const bool is_inside =
      share > 0 && share < 1 && distance(p, low) > tolerance && distance(p, high) > tolerance;
  return is_inside && distance(p, foot) <= tolerance ? share : -1;
}

std::vector<OnEdge> vertices_on(const HealingWork& work, const EdgeUse& edge,
                                const std::vector<std::int32_t>& vertices, const BoxTree& tree) {
  const Vec3& low = vertex_at(work.surface, edge.low);
  const Vec3& high = vertex_at(work.surface, edge.high);
  const Vec3 reach{work.tolerance, work.tolerance, work.tolerance};
  Box3 box = point_box(low - reach);
  box.add(low + reach);
  box.add(high - reach);
  box.add(high + reach);
  std::vector<OnEdge> found;
  tree.query(box, [&](std::int32_t i) {
    const std::int32_t v = vertices[static_cast<std::size_t>(i)];
    const Triangle& own = work.surface.triangles[static_cast<std::size_t>(edge.triangle)];
    if (std::ranges::find(own, v) != own.end()) return;
    const double share = share_on_edge(low, high, vertex_at(work.surface, v), work.tolerance);
    if (share > 0) found.push_back({share, v});
  });
  std::ranges::sort(found, [](const OnEdge& a, const OnEdge& b) {
    return std::pair(a.share, a.vertex) < std::pair(b.share, b.vertex);
  });
  return found;
}

/// A fan from the opposite vertex over the parts of the edge.
void divide(HealingWork& work, const EdgeUse& edge, const std::vector<OnEdge>& on) {
  const auto t = static_cast<std::size_t>(edge.triangle);
  const Triangle nodes = work.surface.triangles[t];
  const std::int32_t patch = patch_of(work.surface, t);
  std::vector<std::int32_t> chain = {edge.low};
  for (const OnEdge& v : on) chain.push_back(v.vertex);
  chain.push_back(edge.high);
  std::vector<Triangle> parts;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    Triangle part = nodes;
    *std::ranges::find(part, edge.low) = chain[i];
    *std::ranges::find(part, edge.high) = chain[i + 1];
    parts.push_back(part);
  }
  HealAct act{HealKind::seam, vertex_at(work.surface, on.front().vertex), {}};
  add_triangles(work.surface, parts, patch, act);
  work.acts.push_back(std::move(act));
}

}  // namespace

std::int64_t divide_open_edges(HealingWork& work) {
  const std::vector<EdgeUse> uses = edge_uses(work.surface.triangles);
  std::vector<EdgeUse> open;
  std::vector<std::int32_t> vertices;
  for_each_edge(std::span<const EdgeUse>(uses), [&](std::span<const EdgeUse> edge) {
    if (edge.size() != 1) return;
    open.push_back(edge[0]);
    vertices.insert(vertices.end(), {edge[0].low, edge[0].high});
  });
  std::ranges::sort(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<Box3> boxes;
  for (const std::int32_t v : vertices) boxes.push_back(point_box(vertex_at(work.surface, v)));
  const BoxTree tree(boxes);
  std::vector<char> is_gone(work.surface.triangles.size(), 0);
  std::int64_t divided = 0;
  for (const EdgeUse& edge : open) {
    // A triangle with two such edges has the other divided the next time.
    if (is_gone[static_cast<std::size_t>(edge.triangle)] != 0) continue;
    const std::vector<OnEdge> on = vertices_on(work, edge, vertices, tree);
    if (on.empty()) continue;
    divide(work, edge, on);
    is_gone[static_cast<std::size_t>(edge.triangle)] = 1;
    ++divided;
  }
  is_gone.resize(work.surface.triangles.size(), 0);
  remove_triangles(work.surface, is_gone);
  return divided;
}

}  // namespace tetfarm
