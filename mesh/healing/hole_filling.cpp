#include "mesh/healing/hole_filling.h"

#include <utility>

#include "mesh/healing/border_loops.h"
#include "mesh/healing/loop_filling.h"
#include "mesh/healing/new_triangles.h"

namespace tetfarm {
namespace {

double border_length(const SurfaceMesh& surface, const std::vector<std::int32_t>& loop) {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    length +=
        distance(vertex_at(surface, loop[i]), vertex_at(surface, loop[(i + 1) % loop.size()]));
  }
  return length;
}

}  // namespace

std::int64_t fill_holes(HealingWork& work) {
  SurfaceMesh& surface = work.surface;
  const std::vector<EdgeUse> uses = edge_uses(surface.triangles);
  const std::vector<BorderLoop> loops = border_loops(uses);
  if (loops.empty()) return 0;
  const NearTriangles near(surface);
  std::int64_t filled = 0;
  for (const BorderLoop& loop : loops) {
    if (border_length(surface, loop.vertices) > work.largest_hole) continue;
    const auto made = fill_loop(
        surface.vertices, loop.vertices,
        [&uses](std::int32_t a, std::int32_t b) { return !uses_of_edge(uses, a, b).empty(); });
    if (!made || near.meet(*made, {})) continue;
    const std::int32_t patch = patch_of(surface, static_cast<std::size_t>(loop.triangle));
    HealAct act{HealKind::hole, vertex_at(surface, loop.vertices.front()), {}};
    add_triangles(surface, *made, patch, act);
    work.acts.push_back(std::move(act));
    ++filled;
  }
  return filled;
}

}  // namespace tetfarm
