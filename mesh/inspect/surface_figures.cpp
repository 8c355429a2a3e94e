#include "mesh/inspect/surface_figures.h"

#include <algorithm>

#include "mesh/core/triangle_angles.h"

namespace tetfarm {
void measure_surface(const SurfaceMesh& surface, std::span<const EdgeUse> uses,
                     SurfaceReport& report) {
  const auto at = [&surface](std::int32_t v) -> const Vec3& {
    return surface.vertices[static_cast<std::size_t>(v)];
  };
  std::vector<double> lengths;
  lengths.reserve(uses.size() / 2);
  std::vector<char> is_measured(surface.triangles.size(), 0);
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    lengths.push_back(distance(at(edge[0].low), at(edge[0].high)));
    for (const EdgeUse& use : edge) is_measured[static_cast<std::size_t>(use.triangle)] = 1;
  });
  if (!lengths.empty()) {
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    report.median_edge = *middle;
    report.shortest_edge = *std::min_element(lengths.begin(), middle + 1);
    report.longest_edge = *std::max_element(middle, lengths.end());
  }
  double angle = 180;
  std::vector<char> is_used(surface.vertices.size(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Triangle& nodes = surface.triangles[t];
    for (const std::int32_t v : nodes) {
      if (v >= 0 && static_cast<std::size_t>(v) < is_used.size()) {
        is_used[static_cast<std::size_t>(v)] = 1;
      }
    }
    if (is_measured[t] == 0) continue;
    angle = std::min(angle, smallest_angle_deg(at(nodes[0]), at(nodes[1]), at(nodes[2])));
  }
  if (!lengths.empty()) report.smallest_angle_deg = angle;
  report.unused_vertices = std::count(is_used.begin(), is_used.end(), 0);
}

}  // namespace tetfarm
