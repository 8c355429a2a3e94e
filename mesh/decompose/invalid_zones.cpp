#include "mesh/decompose/invalid_zones.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {

std::vector<double> area_in_invalid_zones(const Subdomain& subdomain,
                                          const SurfaceTopology& topology, const Vec3& unit_normal,
                                          const std::vector<double>& offsets) {
  constexpr double cosine_squared = 0.75;  // 30 degrees; the thesis gives no value
  constexpr std::size_t enough = 20000;
  const std::size_t stride = 1 + subdomain.triangles.size() / enough;
  TF_CHECK(topology.normal.size() == subdomain.triangles.size());
  std::vector<double> area(offsets.size(), 0.0);
  for (std::size_t t = stride / 2; t < subdomain.triangles.size(); t += stride) {
    if (is_of_cut(subdomain.triangle_origin[t])) continue;
    const double along = dot(topology.normal[t], unit_normal);
    const double length2 = norm2(topology.normal[t]);
    if (along * along <= cosine_squared * length2) continue;
    const auto& [a, b, c] = subdomain.triangles[t];
    const double at_a = dot(subdomain.vertices[at(a)], unit_normal);
    const double at_b = dot(subdomain.vertices[at(b)], unit_normal);
    const double at_c = dot(subdomain.vertices[at(c)], unit_normal);
    const double low = std::min({at_a, at_b, at_c}) - topology.size[t];
    const double high = std::max({at_a, at_b, at_c}) + topology.size[t];
    for (std::size_t i = 0; i < offsets.size(); ++i) {
      if (low < offsets[i] && offsets[i] < high) {
        area[i] += 0.5 * std::sqrt(length2) * static_cast<double>(stride);
      }
    }
  }
  return area;
}

}  // namespace tetfarm
