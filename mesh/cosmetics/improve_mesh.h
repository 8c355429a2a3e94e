/// First cosmetics of a volume mesh (thesis 4.3.4.1): face swaps, edge removal, smoothing,
/// collapse.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "mesh/core/tet_complex.h"

namespace tetfarm {

struct CosmeticOptions {
  /// Tets whose smallest dihedral angle is below this are worked on.
  double wanted_dihedral_deg = 30;
  /// Nodes of tets below this are relaxed at the end, for rounder tets on average. 0: none.
  double relaxed_dihedral_deg = 45;
  int most_passes = 6;
  /// Target edge length at a point: a guard for collapses and splits. Empty: no guard.
  std::function<double(const Vec3&)> spacing;
};

struct CosmeticReport {
  double min_dihedral_before_deg = 0;
  double min_dihedral_after_deg = 0;
  std::int64_t swaps = 0;
  std::int64_t moves = 0;
  std::int64_t collapses = 0;
  std::int64_t splits = 0;
};

/// Worst first; never makes the worst element of a touched ball worse. Nodes below `fixed_nodes`
/// and the boundary faces (no neighbour) stay as they are. Interior nodes may be moved, removed or
/// added; on return the complex is valid, removed points have node2tet == -1. Deterministic. Cost:
/// proportional to the number of tets below the wanted angle, plus one scan a pass.
CosmeticReport improve_mesh(TetComplex& complex, std::int32_t fixed_nodes,
                            const CosmeticOptions& options = {});

}  // namespace tetfarm
