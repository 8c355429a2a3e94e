/// The edges of a surface with the triangles on them, and those that are open.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/inspect/surface_report.h"

namespace tetfarm {

/// One triangle's use of the edge between vertices low < high.
struct EdgeUse {
  std::int32_t low = 0;
  std::int32_t high = 0;
  std::int32_t triangle = 0;
  bool forward = false;  // the triangle runs from low to high
};

/// All uses by the triangles that the sieve lets through, sorted by edge, then triangle.
/// Cost: O(n log n).
std::vector<EdgeUse> edge_uses(const std::vector<Triangle>& triangles,
                               const std::vector<char>& sieve);

/// The same of all triangles.
std::vector<EdgeUse> edge_uses(const std::vector<Triangle>& triangles);

/// Calls visit(span of uses) for each edge.
template <typename Visitor>
void for_each_edge(std::span<const EdgeUse> uses, Visitor&& visit) {
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t end = i + 1;
    while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high)
      ++end;
    visit(uses.subspan(i, end - i));
    i = end;
  }
}

/// "open edge": used by one triangle; the message says when vertices on open edges lie so close
/// together that they were probably meant to be one, and when sheets hang on the surface.
std::optional<SurfaceDefect> check_edges(const SurfaceMesh& surface, std::span<const EdgeUse> uses);

}  // namespace tetfarm
