#include "mesh/recovery/recovery_surface.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
RecoverySurface::RecoverySurface(std::span<const Triangle> triangles, std::int32_t nodes)
    : triangles_(triangles), edge_begin_(at(nodes) + 1, 0), triangle_begin_(at(nodes) + 1, 0) {
  std::vector<std::array<std::int32_t, 2>> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) {
    TF_CHECK(std::min({t[0], t[1], t[2]}) >= 0 && std::max({t[0], t[1], t[2]}) < nodes);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      edges.push_back({low, high});
    }
    ++triangle_begin_[at(std::min({t[0], t[1], t[2]})) + 1];
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& [a, b] : edges) {
    ++edge_begin_[at(a) + 1];
    edge_end_node_.push_back(b);
  }
  for (std::size_t v = 0; v < at(nodes); ++v) {
    edge_begin_[v + 1] += edge_begin_[v];
    triangle_begin_[v + 1] += triangle_begin_[v];
  }
  triangle_.resize(triangles.size());
  std::vector<std::int32_t> next = triangle_begin_;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    triangle_[at(next[at(std::min({t[0], t[1], t[2]}))]++)] = static_cast<std::int32_t>(i);
  }
}

std::vector<std::array<std::int32_t, 2>> RecoverySurface::edges() const {
  std::vector<std::array<std::int32_t, 2>> all;
  all.reserve(edge_end_node_.size());
  for (std::int32_t a = 0; a < nodes(); ++a) {
    for (std::int32_t i = edge_begin_[at(a)]; i < edge_begin_[at(a) + 1]; ++i) {
      all.push_back({a, edge_end_node_[at(i)]});
    }
  }
  return all;
}

bool RecoverySurface::has_edge(std::int32_t a, std::int32_t b) const {
  const auto [low, high] = std::minmax(a, b);
  if (low < 0 || low >= nodes()) return false;
  const auto begin = edge_end_node_.begin() + edge_begin_[at(low)];
  const auto end = edge_end_node_.begin() + edge_begin_[at(low) + 1];
  return std::binary_search(begin, end, high);
}

std::int32_t RecoverySurface::find_triangle(std::int32_t a, std::int32_t b, std::int32_t c) const {
  const std::int32_t low = std::min({a, b, c});
  if (low < 0 || low >= nodes()) return -1;
  for (std::int32_t i = triangle_begin_[at(low)]; i < triangle_begin_[at(low) + 1]; ++i) {
    const Triangle& t = triangles_[at(triangle_[at(i)])];
    const auto holds = [&t](std::int32_t v) { return t[0] == v || t[1] == v || t[2] == v; };
    if (holds(a) && holds(b) && holds(c)) return triangle_[at(i)];
  }
  return -1;
}

}  // namespace tetfarm
