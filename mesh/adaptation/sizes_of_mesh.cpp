#include "mesh/adaptation/sizes_of_mesh.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/array_index.h"

namespace tetfarm {

std::vector<Metric2> sizes_of_mesh(const TriangleComplex& complex) {
  std::vector<double> sums(complex.points.size(), 0);
  std::vector<std::int32_t> counts(complex.points.size(), 0);
  for (const std::array<std::int32_t, 2>& edge : edges_of(complex)) {
    const Vec2& a = complex.point(edge[0]);
    const Vec2& b = complex.point(edge[1]);
    const Vec2 way{b.x - a.x, b.y - a.y};
    const double length = std::sqrt(way.x * way.x + way.y * way.y);
    for (const std::int32_t node : edge) {
      sums[at(node)] += length;
      ++counts[at(node)];
    }
  }
  std::vector<Metric2> metrics;
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const double size = counts[v] > 0 ? sums[v] / counts[v] : 1;
    metrics.push_back(metric_of_sizes({size, size, 0}));
  }
  return metrics;
}

}  // namespace tetfarm
