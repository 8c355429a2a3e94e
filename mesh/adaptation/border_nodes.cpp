#include "mesh/adaptation/border_nodes.h"

#include <algorithm>
#include <utility>

#include "base/array_index.h"

namespace tetfarm {

BorderNodes::BorderNodes(const MetricMesh& mesh) {
  for (std::int32_t v = 0; v < mesh.nodes(); ++v) {
    if (mesh.is_inside(v) || mesh.complex.node2triangle[at(v)] < 0) continue;
    by_x_.push_back({mesh.complex.point(v).x, v});
  }
  std::stable_sort(by_x_.begin(), by_x_.end(),
                   [](const Entry& a, const Entry& b) { return a.x < b.x; });
}

bool BorderNodes::any_in_triangle(const MetricMesh& mesh, std::int32_t a, std::int32_t b,
                                  std::int32_t c) const {
  const Vec2& p = mesh.complex.point(a);
  Vec2 q = mesh.complex.point(b);
  Vec2 r = mesh.complex.point(c);
  if (orient2d(p, q, r) < 0) std::swap(q, r);
  const auto [low_x, high_x] = std::minmax({p.x, q.x, r.x});
  const auto [low_y, high_y] = std::minmax({p.y, q.y, r.y});
  auto entry = std::lower_bound(by_x_.begin(), by_x_.end(), low_x,
                                [](const Entry& e, double x) { return e.x < x; });
  for (; entry != by_x_.end() && entry->x <= high_x; ++entry) {
    const std::int32_t v = entry->node;
    if (v == a || v == b || v == c || mesh.complex.node2triangle[at(v)] < 0) continue;
    const Vec2& s = mesh.complex.point(v);
    if (s.y < low_y || s.y > high_y) continue;
    if (orient2d(p, q, s) >= 0 && orient2d(q, r, s) >= 0 && orient2d(r, p, s) >= 0) return true;
  }
  return false;
}

}  // namespace tetfarm
