#include "mesh/remeshing/feature_curves.h"

#include <array>

namespace tetfarm {
namespace {

using EdgesOfVertex = std::array<std::int32_t, 2>;

/// Of vertices on curves.
std::vector<EdgesOfVertex> edges_of_vertices(const SurfaceFeatures& features) {
  std::vector<EdgesOfVertex> edges(features.kind.size(), EdgesOfVertex{-1, -1});
  for (std::size_t e = 0; e < features.edges.size(); ++e) {
    for (const std::int32_t v : features.edges[e]) {
      EdgesOfVertex& two = edges[static_cast<std::size_t>(v)];
      two[two[0] < 0 ? 0 : 1] = static_cast<std::int32_t>(e);
    }
  }
  return edges;
}

}  // namespace

FeatureCurves feature_curves(const SurfaceFeatures& features) {
  const std::vector<EdgesOfVertex> edges = edges_of_vertices(features);
  FeatureCurves curves;
  curves.curve_of_edge.assign(features.edges.size(), -1);
  curves.curve_of_vertex.assign(features.kind.size(), -1);
  std::vector<std::int32_t> waiting;
  for (std::size_t e = 0; e < features.edges.size(); ++e) {
    if (curves.curve_of_edge[e] >= 0) continue;
    waiting.assign(1, static_cast<std::int32_t>(e));
    curves.curve_of_edge[e] = curves.count;
    while (!waiting.empty()) {
      const auto edge = static_cast<std::size_t>(waiting.back());
      waiting.pop_back();
      for (const std::int32_t v : features.edges[edge]) {
        const auto vertex = static_cast<std::size_t>(v);
        if (features.kind[vertex] != VertexKind::on_curve) continue;
        curves.curve_of_vertex[vertex] = curves.count;
        for (const std::int32_t next : edges[vertex]) {
          if (next < 0 || curves.curve_of_edge[static_cast<std::size_t>(next)] >= 0) continue;
          curves.curve_of_edge[static_cast<std::size_t>(next)] = curves.count;
          waiting.push_back(next);
        }
      }
    }
    ++curves.count;
  }
  return curves;
}

}  // namespace tetfarm
