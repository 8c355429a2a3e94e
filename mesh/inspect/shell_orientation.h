/// Splits a surface into shells and makes the triangles of each agree on a side.
///
/// Source: flood fill over the edges that two triangles share; neighbours agree when they run along
/// their edge in opposite directions.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/inspect/surface_edges.h"
#include "mesh/inspect/surface_report.h"

namespace tetfarm {

struct ShellOrientation {
  /// The triangles of each shell, sorted; shells in the order of their first triangle. Shells that
  /// share only vertices, or edges of more than two triangles, are apart.
  std::vector<std::vector<std::int32_t>> shells;
  std::vector<std::int32_t> triangle2shell;  // -1: not let through by the sieve
  /// Whether a triangle has to be turned to agree with the first of its shell.
  std::vector<char> turn;
  /// "non-orientable shell": no choice of sides makes all neighbours agree, as on a Möbius strip.
  std::optional<SurfaceDefect> defect;
};

/// @pre `uses` come from the triangles that the sieve lets through. Cost: O(n).
ShellOrientation orient_shells(const SurfaceMesh& surface, std::span<const EdgeUse> uses,
                               const std::vector<char>& sieve);

}  // namespace tetfarm
