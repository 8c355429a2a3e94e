#include "mesh/decompose/edge_path_smoothing.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

/// A run of triangles of one colour round a node: half-edges [first, first + length) of its round.
struct Fan {
  std::size_t first = 0;
  std::size_t length = 0;
};

std::vector<Fan> fans_round(const FaceColours& colours, const std::vector<HalfEdge>& round) {
  const std::size_t n = round.size();
  const auto colour = [&](std::size_t i) { return colours[at(triangle_of(round[i % n]))]; };
  std::vector<Fan> fans;
  for (std::size_t i = 0; i < n; ++i) {
    if (colour(i) != colour(i + n - 1)) fans.push_back({i, 0});
  }
  for (std::size_t f = 0; f < fans.size(); ++f) {
    const std::size_t end = f + 1 < fans.size() ? fans[f + 1].first : fans.front().first + n;
    fans[f].length = end - fans[f].first;
  }
  return fans;
}

bool open_pinch(FaceColours& colours, const SurfaceTopology& topology, HalfEdge from_node) {
  TF_CHECK(from_node >= 0);  // every vertex is used
  const std::vector<HalfEdge> round = half_edges_round_start(topology, from_node);
  bool has_changed = false;
  while (true) {
    const std::vector<Fan> fans = fans_round(colours, round);
    if (fans.size() <= 2) return has_changed;
    const Fan smallest = *std::min_element(
        fans.begin(), fans.end(), [](const Fan& a, const Fan& b) { return a.length < b.length; });
    for (std::size_t i = smallest.first; i < smallest.first + smallest.length; ++i) {
      Side& side = colours[at(triangle_of(round[i % round.size()]))];
      side = other(side);
    }
    has_changed = true;
  }
}

/// The patch of one colour round `seed`, or nothing when it has more than `most` triangles.
std::vector<std::int32_t> small_patch(const FaceColours& colours, const SurfaceTopology& topology,
                                      std::int32_t seed, std::size_t most) {
  std::vector<std::int32_t> patch = {seed};
  for (std::size_t i = 0; i < patch.size(); ++i) {
    for (int e = 0; e < 3; ++e) {
      const std::int32_t neighbour = triangle_of(topology.twin[at(half_edge(patch[i], e))]);
      if (colours[at(neighbour)] != colours[at(seed)]) continue;
      if (std::find(patch.begin(), patch.end(), neighbour) != patch.end()) continue;
      patch.push_back(neighbour);
      if (patch.size() > most) return {};
    }
  }
  return patch;
}

}  // namespace

void smooth_edge_path(FaceColours& colours, const SurfaceTopology& topology) {
  std::vector<std::int32_t> queue;
  TF_CHECK(topology.twin.size() == 3 * colours.size());
  const auto triangles = static_cast<std::int32_t>(colours.size());
  for (std::int32_t t = 0; t < triangles; ++t) {
    if (edges_between_colours(colours, topology, t) >= 2) queue.push_back(t);
  }
  while (!queue.empty()) {
    const std::int32_t t = queue.back();
    queue.pop_back();
    if (edges_between_colours(colours, topology, t) < 2) continue;
    colours[at(t)] = other(colours[at(t)]);
    for (int e = 0; e < 3; ++e) queue.push_back(triangle_of(topology.twin[at(half_edge(t, e))]));
  }
}

int open_pinches(FaceColours& colours, const SurfaceTopology& topology,
                 const std::vector<Triangle>& triangles) {
  int opened = 0;
  const auto half_edges = static_cast<HalfEdge>(topology.twin.size());
  for (HalfEdge h = 0; h < half_edges; ++h) {
    const HalfEdge twin = topology.twin[at(h)];
    const bool is_on_path =
        colours[at(triangle_of(h))] == Side::left && colours[at(triangle_of(twin))] == Side::right;
    if (!is_on_path) continue;
    const HalfEdge first = topology.vertex2half_edge[at(start_of(triangles, h))];
    if (open_pinch(colours, topology, first)) ++opened;
  }
  return opened;
}

int drop_crumbs(FaceColours& colours, const SurfaceTopology& topology) {
  constexpr std::size_t largest_crumb = 10;
  int dropped = 0;
  const auto triangles = static_cast<std::int32_t>(colours.size());
  for (std::int32_t t = 0; t < triangles; ++t) {
    if (edges_between_colours(colours, topology, t) == 0) continue;
    const auto patch = small_patch(colours, topology, t, largest_crumb);
    for (const std::int32_t member : patch) colours[at(member)] = other(colours[at(member)]);
    if (!patch.empty()) ++dropped;
  }
  return dropped;
}

void tidy_path(FaceColours& colours, const SurfaceTopology& topology,
               const std::vector<Triangle>& triangles) {
  constexpr int most_rounds = 8;
  for (int round = 0; round < most_rounds; ++round) {
    smooth_edge_path(colours, topology);
    const int dropped = drop_crumbs(colours, topology);
    const int opened = open_pinches(colours, topology, triangles);
    if (dropped + opened == 0) return;
  }
}

}  // namespace tetfarm
