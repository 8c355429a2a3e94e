#include "mesh/layers/layer_coverage.h"

#include <algorithm>
#include <array>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {

LayerCoverage coverage_of(const LayerPlan& plan, const SurfaceMesh& surface) {
  LayerCoverage coverage;
  TF_CHECK(plan.vertex2line.size() == surface.vertices.size());
  coverage.wall_triangles = std::ssize(plan.wall);
  for (const std::int32_t t : plan.wall) {
    const std::array<std::int32_t, 3> lines = lines_of(plan, surface, t);
    const auto all = [&](const auto& holds) {
      return std::all_of(lines.begin(), lines.end(),
                         [&](std::int32_t line) { return holds(plan.lines[at(line)]); });
    };
    if (all([](const LayerLine& line) { return line.stop == 0; })) {
      ++coverage.none;
    } else if (all([](const LayerLine& line) { return line.stop == line.wanted; })) {
      ++coverage.full;
    }
  }
  for (const LayerLine& line : plan.lines) {
    if (line.reason != StopReason::complete) ++coverage.short_lines[line.reason];
  }
  return coverage;
}

}  // namespace tetfarm
