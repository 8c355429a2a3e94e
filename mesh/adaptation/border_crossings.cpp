#include "mesh/adaptation/border_crossings.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

struct BorderEdge {
  std::int32_t a = 0, b = 0;
  Vec2 low, high;  ///< its box
};

bool touch(const PlaneMesh& mesh, const BorderEdge& e, const BorderEdge& f) {
  if (e.a == f.a || e.a == f.b || e.b == f.a || e.b == f.b) return false;
  if (e.high.y < f.low.y || f.high.y < e.low.y) return false;
  const Vec2& a = mesh.points[at(e.a)];
  const Vec2& b = mesh.points[at(e.b)];
  const Vec2& c = mesh.points[at(f.a)];
  const Vec2& d = mesh.points[at(f.b)];
  const auto apart = [](double first, double second) {
    return (first > 0 && second > 0) || (first < 0 && second < 0);
  };
  return !apart(orient2d(a, b, c), orient2d(a, b, d)) &&
         !apart(orient2d(c, d, a), orient2d(c, d, b));
}

}  // namespace

std::optional<Vec2> find_border_crossing(const PlaneMesh& mesh) {
  std::vector<BorderEdge> edges;
  edges.reserve(mesh.edges.size());
  for (const auto& [a, b] : mesh.edges) {
    TF_CHECK(at(a) < mesh.points.size() && at(b) < mesh.points.size());
    const Vec2& p = mesh.points[at(a)];
    const Vec2& q = mesh.points[at(b)];
    edges.push_back(
        {a, b, {std::min(p.x, q.x), std::min(p.y, q.y)}, {std::max(p.x, q.x), std::max(p.y, q.y)}});
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const BorderEdge& e, const BorderEdge& f) { return e.low.x < f.low.x; });
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const BorderEdge& e = edges[i];
    for (std::size_t k = i + 1; k < edges.size() && edges[k].low.x <= e.high.x; ++k) {
      if (!touch(mesh, e, edges[k])) continue;
      return Vec2{(e.low.x + e.high.x) / 2, (e.low.y + e.high.y) / 2};
    }
  }
  return std::nullopt;
}

}  // namespace tetfarm
