#include "mesh/layers/wall_shells.h"

#include <algorithm>
#include <utility>

#include "base/array_index.h"
#include "base/error.h"
#include "mesh/core/complaints.h"

namespace tetfarm {
namespace {

std::vector<std::int32_t> triangles_of(const SurfaceMesh& surface,
                                       std::span<const std::int32_t> patches) {
  std::vector<std::int32_t> found;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (std::binary_search(patches.begin(), patches.end(), patch_of(surface, t))) {
      found.push_back(static_cast<std::int32_t>(t));
    }
  }
  return found;
}

void require_closed(const SurfaceMesh& surface, std::span<const std::int32_t> patches,
                    const WallGraph& graph) {
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (std::binary_search(patches.begin(), patches.end(), patch_of(surface, t))) continue;
    for (const std::int32_t v : surface.triangles[t]) {
      if (graph.vertex2line[at(v)] < 0) continue;
      throw UsageError("their patches do not close: at " + text_of(surface.vertices[at(v)]) +
                           " they meet \"" + surface.patch_names.at(at(patch_of(surface, t))) +
                           "\", which is none of them; name all patches of the outer boundary, or "
                           "take corners = \"block\" where they are sides of a box",
                       "absorbing layers");
    }
  }
}

/// The shell of each line, by the first of its lines.
std::vector<std::int32_t> shell_of_lines(const WallGraph& graph) {
  std::vector<std::int32_t> shells(graph.feet.size(), -1);
  std::vector<std::int32_t> waiting;
  for (std::size_t first = 0; first < shells.size(); ++first) {
    if (shells[first] >= 0) continue;
    waiting.push_back(static_cast<std::int32_t>(first));
    shells[first] = static_cast<std::int32_t>(first);
    while (!waiting.empty()) {
      const std::int32_t line = waiting.back();
      waiting.pop_back();
      for (const std::int32_t next : graph.neighbours.of(line)) {
        if (shells[at(next)] >= 0) continue;
        shells[at(next)] = static_cast<std::int32_t>(first);
        waiting.push_back(next);
      }
    }
  }
  return shells;
}

}  // namespace

WallGraph graph_of_whole_shells(const SurfaceMesh& surface, std::span<const std::int32_t> patches) {
  WallGraph graph = wall_graph(surface, triangles_of(surface, patches));
  require_closed(surface, patches, graph);
  return graph;
}

std::vector<ClosedShell> shells_of(const SurfaceMesh& surface, const WallGraph& graph) {
  const std::vector<std::int32_t> shell_of = shell_of_lines(graph);
  std::vector<ClosedShell> by_first(graph.feet.size());
  for (std::size_t i = 0; i < shell_of.size(); ++i) {
    by_first[at(shell_of[i])].vertices.push_back(graph.feet[i]);
  }
  for (const std::int32_t t : graph.wall) {
    const Triangle& triangle = surface.triangles[at(t)];
    by_first[at(shell_of[at(graph.vertex2line[at(triangle[0])])])].triangles.push_back(triangle);
  }
  std::erase_if(by_first, [](const ClosedShell& shell) { return shell.triangles.empty(); });
  return by_first;
}

Vec3 outward_normal(const SurfaceMesh& surface, const Triangle& t) {
  const Vec3 a = surface.vertices[at(t[0])];
  return normalized(cross(surface.vertices[at(t[1])] - a, surface.vertices[at(t[2])] - a));
}

}  // namespace tetfarm
