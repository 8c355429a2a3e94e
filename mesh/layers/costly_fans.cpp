#include "mesh/layers/costly_fans.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/array_index.h"
#include "mesh/layers/wall_graph.h"

namespace tetfarm {
namespace {

/// The feet at most so many edges away from a foot, itself among them, ascending.
std::set<std::int32_t> feet_near(const WallGraph& graph, std::int32_t foot, int edges) {
  std::set<std::int32_t> lines = {graph.vertex2line[at(foot)]};
  for (int edge = 0; edge < edges; ++edge) {
    const std::set<std::int32_t> before = lines;
    for (const std::int32_t line : before) {
      const auto neighbours = graph.neighbours.of(line);
      lines.insert(neighbours.begin(), neighbours.end());
    }
  }
  std::set<std::int32_t> feet;
  for (const std::int32_t line : lines) feet.insert(graph.feet[at(line)]);
  return feet;
}

bool has_several_lines(const LayerPlan& plan, std::int32_t foot) {
  const std::size_t second = at(plan.vertex2line[at(foot)]) + 1;
  return second < plan.lines.size() && plan.lines[second].foot == foot;
}

}  // namespace

std::vector<CostlyFans> costly_fans(const LayerPlan& plan, const SurfaceMesh& surface, int edges) {
  std::map<std::int32_t, std::set<std::int32_t>> held_by;  // by the foot where cells fold
  for (const LayerLine& line : plan.lines) {
    const bool is_of_cells = line.reason == StopReason::fold || line.reason == StopReason::crossing;
    if (is_of_cells) held_by[line.because_of].insert(line.foot);
  }
  if (held_by.empty() || plan.fans.empty()) return {};
  const WallGraph graph = wall_graph(surface, plan.wall);
  std::vector<CostlyFans> costly;
  for (const auto& [place, held] : held_by) {
    CostlyFans here;
    for (const std::int32_t foot : feet_near(graph, place, edges)) {
      if (has_several_lines(plan, foot)) here.fans.push_back(foot);
    }
    if (here.fans.empty()) continue;
    here.held.assign(held.begin(), held.end());
    costly.push_back(std::move(here));
  }
  return costly;
}

std::int64_t missing_layers_at(const LayerPlan& plan, const std::vector<std::int32_t>& feet) {
  std::int64_t missing = 0;
  for (const std::int32_t foot : feet) {
    int most = 0;
    for (std::size_t i = at(plan.vertex2line[at(foot)]);
         i < plan.lines.size() && plan.lines[i].foot == foot; ++i) {
      most = std::max(most, plan.lines[i].wanted - plan.lines[i].stop);
    }
    missing += most;
  }
  return missing;
}

std::int64_t missing_layers(const LayerPlan& plan) {
  std::set<std::int32_t> feet;
  for (const LayerLine& line : plan.lines) feet.insert(line.foot);
  return missing_layers_at(plan, {feet.begin(), feet.end()});
}

}  // namespace tetfarm
