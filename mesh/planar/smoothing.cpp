#include "mesh/planar/smoothing.h"

#include <algorithm>
#include <vector>

#include "base/check.h"

namespace tetfarm {
namespace {

/// The edges opposite a node, anticlockwise: from[k] to from[k + 1].
void collect_ball(const TriangleComplex& complex, std::int32_t v, std::vector<std::int32_t>& from) {
  from.clear();
  const std::int32_t first = complex.node2triangle[static_cast<std::size_t>(v)];
  std::int32_t t = first;
  int local = complex.local_node(t, v);
  do {
    from.push_back(complex.node(t, next(local)));
    const EdgeHandle onward = complex.neighbour(t, next(local));
    TF_CHECK(onward != no_edge);  // the node lies inside
    t = triangle_of(onward);
    local = next(edge_of(onward));
  } while (t != first);
}

double worst_quality(const TriangleComplex& complex, const std::vector<std::int32_t>& ring,
                     const Vec2& p) {
  double worst = 1;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const std::int32_t to = ring[k + 1 < ring.size() ? k + 1 : 0];
    worst = std::min(worst, triangle_quality(p, complex.point(ring[k]), complex.point(to)));
  }
  return worst;
}

bool all_anticlockwise(const TriangleComplex& complex, const std::vector<std::int32_t>& ring,
                       const Vec2& p) {
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const std::int32_t to = ring[k + 1 < ring.size() ? k + 1 : 0];
    if (!(orient2d(p, complex.point(ring[k]), complex.point(to)) > 0)) return false;
  }
  return true;
}

}  // namespace

double triangle_quality(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double abx = b.x - a.x;
  const double aby = b.y - a.y;
  const double acx = c.x - a.x;
  const double acy = c.y - a.y;
  const double bcx = c.x - b.x;
  const double bcy = c.y - b.y;
  constexpr double twice_sqrt3 = 3.4641016151377544;
  return twice_sqrt3 * (abx * acy - aby * acx) /
         (abx * abx + aby * aby + acx * acx + acy * acy + bcx * bcx + bcy * bcy);
}

std::size_t smooth(TriangleComplex& complex, std::int32_t first_free) {
  TF_CHECK(first_free >= 0);
  std::size_t moved = 0;
  std::vector<std::int32_t> ring;
  const auto n = static_cast<std::int32_t>(complex.points.size());
  for (std::int32_t v = first_free; v < n; ++v) {
    collect_ball(complex, v, ring);
    Vec2 mean;
    for (const std::int32_t w : ring) {
      mean.x += complex.point(w).x;
      mean.y += complex.point(w).y;
    }
    const auto count = static_cast<double>(ring.size());
    mean = {mean.x / count, mean.y / count};
    const Vec2 old = complex.point(v);
    const double before = worst_quality(complex, ring, old);
    for (const double step : {1.0, 0.5}) {
      const Vec2 p{old.x + step * (mean.x - old.x), old.y + step * (mean.y - old.y)};
      if (p == old || worst_quality(complex, ring, p) < before ||
          !all_anticlockwise(complex, ring, p))
        continue;
      complex.points[static_cast<std::size_t>(v)] = p;
      ++moved;
      break;
    }
  }
  return moved;
}

}  // namespace tetfarm
