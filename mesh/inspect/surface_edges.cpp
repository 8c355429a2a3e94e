#include "mesh/inspect/surface_edges.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "base/check.h"
#include "base/counted.h"
#include "mesh/core/complaints.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/inspect/defect_text.h"

namespace tetfarm {
namespace {

// Vertices nearer than this share of the surface's size were probably meant to be one.
constexpr double close_share = 1e-9;

const Vec3& vertex(const SurfaceMesh& surface, std::int32_t v) {
  return surface.vertices[static_cast<std::size_t>(v)];
}

struct OpenEdges {
  std::size_t count = 0;
  std::vector<std::string> places;
  std::vector<std::int64_t> triangles;

  void add(const SurfaceMesh& surface, const EdgeUse& use) {
    ++count;
    triangles.push_back(use.triangle);
    if (places.size() == places_named) return;
    places.push_back("edge from vertex " + std::to_string(use.low) + " " +
                     text_of(vertex(surface, use.low)) + " to " + std::to_string(use.high) + " " +
                     text_of(vertex(surface, use.high)) + " of triangle " +
                     std::to_string(use.triangle));
  }

  SurfaceDefect defect(const std::string& what) {
    std::ranges::sort(triangles);
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    return {"open edge", with_places(what, places, count), triangles};
  }
};

/// Vertices on open edges that lie close to another one.
struct CloseVertices {
  std::size_t pairs = 0;
  double farthest = 0;
};

CloseVertices close_vertices(const SurfaceMesh& surface, std::span<const EdgeUse> uses) {
  std::vector<std::int32_t> ends;
  Box3 all;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    all.add(vertex(surface, edge[0].low));
    if (edge.size() == 1) ends.insert(ends.end(), {edge[0].low, edge[0].high});
  });
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  const double reach = close_share * norm(all.size());
  const Vec3 half{0.5 * reach, 0.5 * reach, 0.5 * reach};
  std::vector<Box3> boxes;
  for (const std::int32_t v : ends) {
    boxes.push_back({vertex(surface, v) - half, vertex(surface, v) + half});
  }
  CloseVertices close;
  BoxTree(boxes).self_pairs([&](std::int32_t i, std::int32_t j) {
    const double apart = distance(vertex(surface, ends[static_cast<std::size_t>(i)]),
                                  vertex(surface, ends[static_cast<std::size_t>(j)]));
    if (apart > reach) return;
    ++close.pairs;
    close.farthest = std::max(close.farthest, apart);
  });
  return close;
}

}  // namespace

std::vector<EdgeUse> edge_uses(const std::vector<Triangle>& triangles,
                               const std::vector<char>& sieve) {
  std::vector<EdgeUse> uses;
  TF_CHECK(sieve.size() == triangles.size());
  uses.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (sieve[t] == 0) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t from = triangles[t][i];
      const std::int32_t to = triangles[t][(i + 1) % 3];
      uses.push_back(
          {std::min(from, to), std::max(from, to), static_cast<std::int32_t>(t), from < to});
    }
  }
  std::ranges::sort(uses, {},
                    [](const EdgeUse& e) { return std::tuple(e.low, e.high, e.triangle); });
  return uses;
}

std::vector<EdgeUse> edge_uses(const std::vector<Triangle>& triangles) {
  return edge_uses(triangles, std::vector<char>(triangles.size(), 1));
}

std::optional<SurfaceDefect> check_edges(const SurfaceMesh& surface,
                                         std::span<const EdgeUse> uses) {
  OpenEdges open;
  std::size_t crowded = 0;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 1) open.add(surface, edge[0]);
    if (edge.size() > 2) ++crowded;
  });
  if (open.count == 0) return std::nullopt;
  std::string what = counted(open.count, "open edge") + " (on one triangle only)";
  if (const CloseVertices close = close_vertices(surface, uses); close.pairs > 0) {
    what += "; " + counted(close.pairs, "pair") + " of vertices on them lie " +
            (close.farthest > 0 ? "within " + text_of(close.farthest) : "in the same place") +
            ": joining these may close the surface";
  }
  if (crowded > 0) {
    what +=
        "; " + counted(crowded, "edge") + (crowded == 1 ? " is" : " are") +
        " on more than two triangles: a sheet that ends inside a region divides nothing; remove "
        "it, or continue it to the boundary";
  }
  return open.defect(what);
}

}  // namespace tetfarm
