#include "mesh/adaptation/mesh_compaction.h"

#include <algorithm>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/core/vec3.h"
#include "mesh/geometry/hilbert_order.h"

namespace tetfarm {
namespace {

/// The old numbers in their new order, and the new number of each old one (-1: gone).
struct Renumbering {
  std::vector<std::int32_t> order;
  std::vector<std::int32_t> number;
};

Renumbering renumbering_of(std::vector<std::int32_t> order, std::size_t before) {
  Renumbering result{std::move(order), std::vector<std::int32_t>(before, -1)};
  for (std::size_t k = 0; k < result.order.size(); ++k) {
    result.number[at(result.order[k])] = static_cast<std::int32_t>(k);
  }
  return result;
}

Renumbering of_nodes(const MetricMesh& mesh) {
  std::vector<std::int32_t> used;
  used.reserve(mesh.complex.points.size());
  for (std::int32_t v = 0; v < mesh.nodes(); ++v) {
    if (mesh.complex.node2triangle[at(v)] >= 0) used.push_back(v);
  }
  std::vector<std::int32_t> order = hilbert_order(used.size(), [&](std::size_t k) {
    const Vec2& p = mesh.complex.point(used[k]);
    return Vec3{p.x, p.y, 0};
  });
  for (std::int32_t& v : order) v = used[at(v)];
  return renumbering_of(std::move(order), mesh.complex.points.size());
}

/// By the lowest of their nodes' new numbers, then by their old numbers.
Renumbering of_triangles(const MetricMesh& mesh, const Renumbering& nodes) {
  const auto lowest = [&](std::int32_t t) {
    const TriangleComplex::Nodes& n = mesh.complex.nodes(t);
    return std::min({nodes.number[at(n[0])], nodes.number[at(n[1])], nodes.number[at(n[2])]});
  };
  std::vector<std::int32_t> starts(nodes.order.size() + 1, 0);
  for (std::int32_t t = 0; t < mesh.complex.size(); ++t) {
    if (mesh.is_used(t)) ++starts[at(lowest(t)) + 1];
  }
  for (std::size_t v = 1; v < starts.size(); ++v) starts[v] += starts[v - 1];
  std::vector<std::int32_t> order(at(starts.back()));
  for (std::int32_t t = 0; t < mesh.complex.size(); ++t) {
    if (mesh.is_used(t)) order[at(starts[at(lowest(t))]++)] = t;
  }
  return renumbering_of(std::move(order), mesh.complex.triangles.size());
}

template <class Item>
void reorder(std::vector<Item>& items, const std::vector<std::int32_t>& order) {
  std::vector<Item> reordered;
  reordered.reserve(order.size() + order.size() / 32);  // some come yet
  for (const std::int32_t k : order) reordered.push_back(items[at(k)]);
  items = std::move(reordered);
}

void renumber_nodes(MetricMesh& mesh, const Renumbering& nodes) {
  TriangleComplex& complex = mesh.complex;
  reorder(complex.points, nodes.order);
  reorder(complex.node2triangle, nodes.order);
  reorder(mesh.metrics, nodes.order);
  reorder(mesh.homes, nodes.order);
  reorder(mesh.curve_of_node, nodes.order);
  reorder(mesh.parameters, nodes.order);
  reorder(mesh.active, nodes.order);
  reorder(mesh.touched, nodes.order);
  for (TriangleComplex::Nodes& of_triangle : complex.triangles) {
    for (std::int32_t& v : of_triangle) v = nodes.number[at(v)];
  }
  std::unordered_map<std::uint64_t, std::int32_t> curve_of_edge;
  curve_of_edge.reserve(mesh.curve_of_edge.size());
  for (const auto& [key, curve] : mesh.curve_of_edge) {
    const auto a = static_cast<std::int32_t>(key >> 32U);
    const auto b = static_cast<std::int32_t>(key & 0xffffffffU);
    curve_of_edge[edge_key(nodes.number[at(a)], nodes.number[at(b)])] = curve;
  }
  mesh.curve_of_edge = std::move(curve_of_edge);
}

void renumber_triangles(MetricMesh& mesh, const Renumbering& triangles) {
  TriangleComplex& complex = mesh.complex;
  reorder(complex.triangles, triangles.order);
  reorder(complex.neighbours, triangles.order);
  reorder(complex.constrained, triangles.order);
  reorder(mesh.regions, triangles.order);
  reorder(mesh.energies, triangles.order);
  reorder(mesh.unchecked, triangles.order);
  mesh.unused.clear();
  for (std::array<EdgeHandle, 3>& of_triangle : complex.neighbours) {
    for (EdgeHandle& edge : of_triangle) {
      if (edge == no_edge) continue;
      edge = edge_handle(triangles.number[at(triangle_of(edge))], edge_of(edge));
    }
  }
  for (std::int32_t& t : complex.node2triangle) {
    if (t >= 0) t = triangles.number[at(t)];  // of nodes that have gone -1
  }
}

}  // namespace

void compact(MetricMesh& mesh) {
  const Renumbering nodes = of_nodes(mesh);
  const Renumbering triangles = of_triangles(mesh, nodes);
  TF_CHECK(triangles.order.size() + mesh.unused.size() == mesh.complex.triangles.size());
  renumber_triangles(mesh, triangles);
  renumber_nodes(mesh, nodes);
}

}  // namespace tetfarm
