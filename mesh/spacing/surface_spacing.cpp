#include "mesh/spacing/surface_spacing.h"

#include <cstddef>

#include "base/check.h"

namespace tetfarm {

std::vector<PointDemand> surface_spacing(const SurfaceMesh& surface) {
  std::vector<double> length_sum(surface.vertices.size(), 0.0);
  std::vector<int> edge_count(surface.vertices.size(), 0);
  for (const Triangle& triangle : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = static_cast<std::size_t>(triangle[k]);
      const auto b = static_cast<std::size_t>(triangle[(k + 1) % 3]);
      TF_CHECK(a < length_sum.size() && b < length_sum.size());
      const double length = distance(surface.vertices[a], surface.vertices[b]);
      length_sum[a] += length;
      length_sum[b] += length;
      ++edge_count[a];
      ++edge_count[b];
    }
  }
  std::vector<PointDemand> demands;
  demands.reserve(surface.vertices.size());
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    if (!(length_sum[v] > 0)) continue;
    const double spacing = length_sum[v] / edge_count[v];
    demands.push_back({surface.vertices[v], spacing, surface_plateau * spacing});
  }
  return demands;
}

}  // namespace tetfarm
