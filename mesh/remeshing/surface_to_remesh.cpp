#include "mesh/remeshing/surface_to_remesh.h"

#include <algorithm>
#include <array>

#include "base/check.h"

namespace tetfarm {
namespace {

std::uint8_t feature_bits(const Triangle& nodes, const SurfaceFeatures& features) {
  std::uint8_t bits = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t a = nodes[k];
    const std::int32_t b = nodes[(k + 1) % 3];
    const std::array<std::int32_t, 2> edge{std::min(a, b), std::max(a, b)};
    if (std::ranges::binary_search(features.edges, edge)) {
      bits = static_cast<std::uint8_t>(bits | 1U << k);
    }
  }
  return bits;
}

}  // namespace

ChangingSurface surface_to_remesh(const SurfaceMesh& surface, const SurfaceFeatures& features,
                                  const InputShape& shape, const RemeshingSpacing& spacing) {
  ChangingSurface changing(bounding_box(surface.vertices));
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    SurfaceVertex vertex;
    vertex.kind = features.kind[v];
    if (vertex.kind == VertexKind::on_curve) {
      vertex.home = shape.curve_of_vertex(static_cast<std::int32_t>(v));
    }
    vertex.spacing = spacing.at(surface.vertices[v]);
    changing.add_vertex(surface.vertices[v], vertex);
  }
  for (std::size_t e = 0; e < features.edges.size(); ++e) {
    for (const std::int32_t v : features.edges[e]) {
      SurfaceVertex& vertex = changing.vertex(v);
      if (vertex.kind == VertexKind::on_curve) vertex.foot = static_cast<std::int32_t>(e);
    }
  }
  TF_CHECK(features.face.size() == surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Triangle& nodes = surface.triangles[t];
    changing.add_triangle({nodes, features.face[t], feature_bits(nodes, features)});
    for (const std::int32_t v : nodes) {
      SurfaceVertex& vertex = changing.vertex(v);
      if (vertex.kind != VertexKind::smooth) continue;
      vertex.home = features.face[t];
      vertex.foot = static_cast<std::int32_t>(t);
    }
  }
  return changing;
}

}  // namespace tetfarm
