#include "mesh/inspect/surface_sides.h"

#include <algorithm>

#include "base/check.h"
#include "base/disjoint_sets.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

/// A triangle at an edge from low to high: its third corner, and which way it runs.
struct Leaf {
  Vec3 apex;
  std::size_t triangle = 0;
  bool forward = false;
  int half = 0;  ///< of the turn that begins at the first leaf: 0 that leaf, 1, 2 opposite, 3
};

/// Round the edge anticlockwise, seen against its direction, a forward triangle shows its front
/// last and its back first.
std::size_t side_after(const Leaf& leaf) {
  return leaf.forward ? side_in_front(leaf.triangle) : side_behind(leaf.triangle);
}
std::size_t side_before(const Leaf& leaf) {
  return leaf.forward ? side_behind(leaf.triangle) : side_in_front(leaf.triangle);
}

Leaf leaf_of(const SurfaceMesh& surface, const EdgeUse& use) {
  Leaf leaf;
  leaf.triangle = static_cast<std::size_t>(use.triangle);
  leaf.forward = use.forward;
  for (const std::int32_t v : surface.triangles[leaf.triangle]) {
    if (v != use.low && v != use.high) leaf.apex = surface.vertices[static_cast<std::size_t>(v)];
  }
  return leaf;
}

/// Sorts the triangles at the edge pq by angle, anticlockwise from the first.
void sort_by_angle(std::vector<Leaf>& leaves, const Vec3& p, const Vec3& q) {
  TF_CHECK(leaves.size() > 2);
  const Vec3 first = leaves.front().apex;
  for (std::size_t i = 1; i < leaves.size(); ++i) {
    const double turn = orient3d(p, q, first, leaves[i].apex);
    leaves[i].half = turn > 0 ? 1 : turn == 0 ? 2 : 3;
  }
  std::sort(leaves.begin(), leaves.end(), [&](const Leaf& a, const Leaf& b) {
    if (a.half != b.half || a.half == 0) return a.half < b.half;
    return orient3d(p, q, a.apex, b.apex) > 0;
  });
}

}  // namespace

SurfaceSides join_sides(const SurfaceMesh& surface, std::span<const EdgeUse> uses) {
  DisjointSets sides(2 * surface.triangles.size());
  DisjointSets triangles(surface.triangles.size());
  std::vector<Leaf> leaves;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    leaves.clear();
    TF_CHECK(edge.size() > 1);  // no edge is open
    for (const EdgeUse& use : edge) leaves.push_back(leaf_of(surface, use));
    if (leaves.size() > 2) {
      sort_by_angle(leaves, surface.vertices[static_cast<std::size_t>(edge[0].low)],
                    surface.vertices[static_cast<std::size_t>(edge[0].high)]);
    }
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      const Leaf& next = leaves[(i + 1) % leaves.size()];
      sides.join(side_after(leaves[i]), side_before(next));
      triangles.join(leaves[i].triangle, next.triangle);
    }
  });
  SurfaceSides result;
  result.sheets = sides.number(result.side2sheet);
  result.parts = triangles.number(result.triangle2part);
  return result;
}

}  // namespace tetfarm
