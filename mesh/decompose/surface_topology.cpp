#include "mesh/decompose/surface_topology.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

/// The half-edges by the smaller of their two nodes: those of node v are list[first[v]] to
/// list[first[v + 1]].
struct HalfEdgesOfNode {
  std::vector<std::int32_t> first;
  std::vector<HalfEdge> list;
};

HalfEdgesOfNode sort_by_smaller_node(const std::vector<Triangle>& triangles, std::size_t nodes) {
  const auto half_edges = static_cast<HalfEdge>(3 * triangles.size());
  HalfEdgesOfNode sorted{std::vector<std::int32_t>(nodes + 1, 0),
                         std::vector<HalfEdge>(at(half_edges))};
  const auto smaller_node = [&](HalfEdge h) {
    return at(std::min(start_of(triangles, h), end_of(triangles, h)));
  };
  for (HalfEdge h = 0; h < half_edges; ++h) ++sorted.first[smaller_node(h) + 1];
  for (std::size_t v = 0; v < nodes; ++v) sorted.first[v + 1] += sorted.first[v];
  std::vector<std::int32_t> next(sorted.first.begin(), sorted.first.end() - 1);
  for (HalfEdge h = 0; h < half_edges; ++h) {
    sorted.list[at(next[smaller_node(h)]++)] = h;
  }
  return sorted;
}

std::vector<HalfEdge> find_twins(const std::vector<Triangle>& triangles, std::size_t nodes) {
  std::vector<HalfEdge> twin(3 * triangles.size(), -1);
  const HalfEdgesOfNode sorted = sort_by_smaller_node(triangles, nodes);
  for (std::size_t v = 0; v < nodes; ++v) {
    for (std::int32_t i = sorted.first[v]; i < sorted.first[v + 1]; ++i) {
      const HalfEdge h = sorted.list[at(i)];
      for (std::int32_t j = i + 1; j < sorted.first[v + 1] && twin[at(h)] < 0; ++j) {
        const HalfEdge g = sorted.list[at(j)];
        if (twin[at(g)] < 0 && start_of(triangles, g) == end_of(triangles, h) &&
            end_of(triangles, g) == start_of(triangles, h)) {
          twin[at(h)] = g;
          twin[at(g)] = h;
        }
      }
      TF_CHECK(twin[at(h)] >= 0);
    }
  }
  return twin;
}

std::vector<std::int32_t> find_shells(const std::vector<HalfEdge>& twin) {
  std::vector<std::int32_t> triangle2shell(twin.size() / 3, -1);
  std::int32_t shells = 0;
  for (std::size_t seed = 0; seed < triangle2shell.size(); ++seed) {
    if (triangle2shell[seed] >= 0) continue;
    triangle2shell[seed] = shells;
    std::vector<std::int32_t> stack = {static_cast<std::int32_t>(seed)};
    while (!stack.empty()) {
      const std::int32_t t = stack.back();
      stack.pop_back();
      for (int e = 0; e < 3; ++e) {
        const std::int32_t neighbour = triangle_of(twin[at(half_edge(t, e))]);
        if (triangle2shell[at(neighbour)] >= 0) continue;
        triangle2shell[at(neighbour)] = shells;
        stack.push_back(neighbour);
      }
    }
    ++shells;
  }
  return triangle2shell;
}

}  // namespace

SurfaceTopology make_surface_topology(const Subdomain& subdomain) {
  const std::vector<Vec3>& vertices = subdomain.vertices;
  const std::vector<Triangle>& triangles = subdomain.triangles;
  SurfaceTopology topology;
  topology.twin = find_twins(triangles, vertices.size());
  topology.triangle2shell = find_shells(topology.twin);
  topology.vertex2half_edge.assign(vertices.size(), -1);
  topology.centroid.reserve(triangles.size());
  topology.normal.reserve(triangles.size());
  topology.size.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Vec3& a = vertices[at(triangles[t][0])];
    const Vec3& b = vertices[at(triangles[t][1])];
    const Vec3& c = vertices[at(triangles[t][2])];
    topology.centroid.push_back((a + b + c) / 3.0);
    topology.normal.push_back(cross(b - a, c - a));
    topology.size.push_back((distance(a, b) + distance(b, c) + distance(c, a)) / 3.0);
    for (int e = 0; e < 3; ++e) {
      HalfEdge& h = topology.vertex2half_edge[at(triangles[t][at(e)])];
      if (h < 0) h = half_edge(static_cast<std::int32_t>(t), e);
    }
  }
  return topology;
}

std::vector<HalfEdge> half_edges_round_start(const SurfaceTopology& topology, HalfEdge h) {
  TF_CHECK(h >= 0);
  std::vector<HalfEdge> round;
  HalfEdge g = h;
  do {
    round.push_back(g);
    TF_CHECK(round.size() <= topology.twin.size());
    g = next_in_triangle(topology.twin[at(g)]);
  } while (g != h);
  return round;
}

}  // namespace tetfarm
