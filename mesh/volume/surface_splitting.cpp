#include "mesh/volume/surface_splitting.h"

#include <numeric>

namespace tetfarm {

SplitSurface unsplit(const std::vector<Triangle>& triangles) {
  SplitSurface surface{triangles, std::vector<std::int32_t>(triangles.size()), {}};
  std::iota(surface.source.begin(), surface.source.end(), 0);
  return surface;
}

void split_edge(SplitSurface& surface, std::int32_t a, std::int32_t b, std::int32_t node) {
  SteinerSplit split{node, {}, {}};
  const std::size_t count = surface.triangles.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Triangle t = surface.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t u = t[k], v = t[(k + 1) % 3], w = t[(k + 2) % 3];
      if (!((u == a && v == b) || (u == b && v == a))) continue;
      split.originals.push_back(t);
      split.sources.push_back(surface.source[i]);
      surface.triangles[i] = {u, node, w};
      surface.triangles.push_back({node, v, w});
      surface.source.push_back(surface.source[i]);
      break;
    }
  }
  surface.splits.push_back(std::move(split));
}

void split_face(SplitSurface& surface, std::int32_t triangle, std::int32_t node) {
  const auto i = static_cast<std::size_t>(triangle);
  const auto [a, b, c] = surface.triangles[i];
  surface.splits.push_back({node, {{a, b, c}}, {surface.source[i]}});
  surface.triangles[i] = {a, b, node};
  surface.triangles.push_back({b, c, node});
  surface.triangles.push_back({c, a, node});
  surface.source.push_back(surface.source[i]);
  surface.source.push_back(surface.source[i]);
}

}  // namespace tetfarm
