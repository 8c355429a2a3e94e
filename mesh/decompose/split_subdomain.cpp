#include "mesh/decompose/split_subdomain.h"

#include <utility>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {

Subdomain half_of(const Subdomain& subdomain, const FaceColours& colours,
                  const InterdomainMesh& mesh, Side side) {
  TF_CHECK(colours.size() == subdomain.triangles.size());
  Subdomain half;
  half.path = side == Side::left ? subdomain.path.left() : subdomain.path.right();
  half.region = subdomain.region;
  std::vector<std::int32_t> old2new(subdomain.vertices.size(), -1);
  constexpr std::int32_t is_used = 0;
  for (std::size_t t = 0; t < colours.size(); ++t) {
    if (colours[t] != side) continue;
    for (const std::int32_t v : subdomain.triangles[t]) old2new[at(v)] = is_used;
  }
  for (std::size_t v = 0; v < old2new.size(); ++v) {
    if (old2new[v] < 0) continue;
    old2new[v] = static_cast<std::int32_t>(half.vertices.size());
    half.vertices.push_back(subdomain.vertices[v]);
    half.node_origin.push_back(subdomain.node_origin[v]);
  }
  for (std::size_t t = 0; t < colours.size(); ++t) {
    if (colours[t] != side) continue;
    const auto& [a, b, c] = subdomain.triangles[t];
    half.triangles.push_back({old2new[at(a)], old2new[at(b)], old2new[at(c)]});
    half.triangle_origin.push_back(subdomain.triangle_origin[t]);
  }
  const auto rim_nodes = static_cast<std::int32_t>(mesh.rim_vertices.size());
  const auto first_new = static_cast<std::int32_t>(half.vertices.size());
  const auto node2new = [&](std::int32_t node) {
    return node < rim_nodes ? old2new[at(mesh.rim_vertices[at(node)])]
                            : first_new + node - rim_nodes;
  };
  const auto nodes = static_cast<std::int32_t>(mesh.planar.points.size());
  for (std::int32_t i = rim_nodes; i < nodes; ++i) {
    half.vertices.push_back(node_position(mesh, subdomain, i));
    half.node_origin.push_back({subdomain.path.heap, static_cast<std::uint32_t>(i - rim_nodes)});
  }
  for (std::size_t t = 0; t < mesh.planar.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.planar.triangles[t];
    Triangle triangle = {node2new(a), node2new(b), node2new(c)};
    TF_CHECK(triangle[0] >= 0 && triangle[1] >= 0 &&
             triangle[2] >= 0);  // the rim is of both halves
    if (side == Side::right) std::swap(triangle[1], triangle[2]);
    half.triangles.push_back(triangle);
    half.triangle_origin.push_back({subdomain.path.heap, static_cast<std::uint32_t>(t)});
  }
  return half;
}

}  // namespace tetfarm
