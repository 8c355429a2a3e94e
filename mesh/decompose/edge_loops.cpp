#include "mesh/decompose/edge_loops.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

std::vector<RimEdge> edges_of_rim(const FaceColours& colours, const SurfaceTopology& topology,
                                  const std::vector<Triangle>& triangles) {
  std::vector<RimEdge> rim;
  TF_CHECK(colours.size() == triangles.size());
  const auto half_edges = static_cast<HalfEdge>(topology.twin.size());
  for (HalfEdge h = 0; h < half_edges; ++h) {
    if (colours[at(triangle_of(h))] != Side::left) continue;
    const HalfEdge twin = topology.twin[at(h)];
    if (colours[at(triangle_of(twin))] != Side::right) continue;
    rim.push_back(
        {end_of(triangles, h), start_of(triangles, h), triangle_of(h), triangle_of(twin)});
  }
  return rim;
}

}  // namespace

EdgeLoops find_edge_loops(const FaceColours& colours, const SurfaceTopology& topology,
                          const std::vector<Triangle>& triangles) {
  const std::vector<RimEdge> rim = edges_of_rim(colours, topology, triangles);
  std::vector<std::int32_t> by_start(rim.size());
  for (std::size_t i = 0; i < rim.size(); ++i) by_start[i] = static_cast<std::int32_t>(i);
  std::sort(by_start.begin(), by_start.end(), [&rim](std::int32_t i, std::int32_t j) {
    return rim[at(i)].from != rim[at(j)].from ? rim[at(i)].from < rim[at(j)].from : i < j;
  });
  EdgeLoops result;
  for (std::size_t i = 0; i + 1 < by_start.size(); ++i) {
    const std::int32_t node = rim[at(by_start[i])].from;
    if (node == rim[at(by_start[i + 1])].from) result.pinched_nodes.push_back(node);
  }
  if (!result.pinched_nodes.empty()) return result;
  const auto edge_from = [&](std::int32_t node) {
    const auto it =
        std::lower_bound(by_start.begin(), by_start.end(), node,
                         [&rim](std::int32_t i, std::int32_t n) { return rim[at(i)].from < n; });
    TF_CHECK(it != by_start.end() && rim[at(*it)].from == node);
    return *it;
  };
  std::vector<bool> is_used(rim.size(), false);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    if (is_used[i]) continue;
    std::vector<RimEdge> loop;
    for (std::int32_t e = static_cast<std::int32_t>(i); !is_used[at(e)];
         e = edge_from(rim[at(e)].to)) {
      is_used[at(e)] = true;
      loop.push_back(rim[at(e)]);
    }
    result.loops.push_back(std::move(loop));
  }
  return result;
}

}  // namespace tetfarm
