#include "mesh/formats/open_edge_welding.h"

#include <algorithm>
#include <vector>

#include "base/check.h"
#include "mesh/formats/vertex_welding.h"

namespace tetfarm {
namespace {

/// The two vertices, the lower first.
std::uint64_t key_of_edge(std::int32_t a, std::int32_t b) {
  TF_CHECK(a >= 0 && b >= 0);
  const auto low = static_cast<std::uint64_t>(std::min(a, b));
  return low << 32 | static_cast<std::uint64_t>(std::max(a, b));
}

template <typename Visitor>
void visit_edges(const SurfaceMesh& surface, Visitor&& visit) {
  for (const Triangle& t : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) visit(key_of_edge(t[k], t[(k + 1) % 3]));
  }
}

std::uint64_t scattered(std::uint64_t key) {
  key *= 0x9e3779b97f4a7c15;
  key ^= key >> 32;
  key *= 0xd6e8feb86659fd93;
  return key ^ key >> 32;
}

/// Whether each edge is on an even number of triangles: the sum without carry of what is as good as
/// a random number for each edge.
bool seems_closed(const SurfaceMesh& surface) {
  std::uint64_t sum = 0;
  visit_edges(surface, [&sum](std::uint64_t edge) { sum ^= scattered(edge); });
  return sum == 0;
}

/// The ends of edges that are on one triangle, in ascending order.
std::vector<std::int32_t> ends_of_open_edges(const SurfaceMesh& surface) {
  std::vector<std::uint64_t> edges;
  edges.reserve(3 * surface.triangles.size());
  visit_edges(surface, [&edges](std::uint64_t edge) { edges.push_back(edge); });
  std::ranges::sort(edges);
  std::vector<std::int32_t> ends;
  for (std::size_t first = 0; first < edges.size();) {
    std::size_t last = first + 1;
    while (last < edges.size() && edges[last] == edges[first]) ++last;
    if (last == first + 1) {
      ends.push_back(static_cast<std::int32_t>(edges[first] >> 32));
      ends.push_back(static_cast<std::int32_t>(edges[first] & 0xffffffffU));
    }
    first = last;
  }
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

}  // namespace

std::int64_t weld_open_edges(SurfaceMesh& surface) {
  if (seems_closed(surface)) return 0;
  const std::vector<std::int32_t> ends = ends_of_open_edges(surface);
  VertexWelding welding(ends.size());
  std::vector<std::int32_t> first_in_place;
  std::vector<std::int32_t> becomes(surface.vertices.size());
  for (std::size_t v = 0; v < becomes.size(); ++v) becomes[v] = static_cast<std::int32_t>(v);
  std::int64_t joined = 0;
  for (const std::int32_t v : ends) {
    const auto at = static_cast<std::size_t>(v);
    const auto place = static_cast<std::size_t>(welding.add(surface.vertices[at]));
    if (place == first_in_place.size()) {
      first_in_place.push_back(v);
    } else {
      becomes[at] = first_in_place[place];
      ++joined;
    }
  }
  if (joined == 0) return 0;
  for (Triangle& t : surface.triangles) {
    for (std::int32_t& v : t) v = becomes[static_cast<std::size_t>(v)];
  }
  return joined;
}

}  // namespace tetfarm
