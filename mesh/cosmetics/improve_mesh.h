/// Cosmetics of a volume mesh: what the mesher leaves badly shaped is swapped, smoothed, collapsed
/// or split until no dihedral angle is below the wanted one, where that can be done.
///
/// Source: thesis 4.3.4.1, which gives the operations but no measure and no order: see
/// mesh/cosmetics/quality.h and docs/decisions/0007-cosmetics-measure.md. Angles in degrees.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "base/work_progress.h"
#include "mesh/core/tet_complex.h"

namespace tetfarm {

/// Tets [first, last) of the mesh that are known without a look: congruent but for their size to
/// those of a body-centred cubic lattice, with angles of 60° and 90°.
struct RegularTets {
  std::int32_t first = 0;
  std::int32_t last = 0;
  /// None is lower.
  double least_height = 0;

  bool holds(std::int32_t t) const { return t >= first && t < last; }
};

struct CosmeticOptions {
  /// Tets whose smallest dihedral angle is below this are worked on.
  double wanted_dihedral_deg = 30;
  /// Tets below this that swaps and moves did not help are collapsed or split.
  double rebuilt_dihedral_deg = 20;
  /// Those above it too, where all that comes of them is as wanted. For small meshes: each costs
  /// some 0.1 ms.
  bool rebuilds_to_wanted = false;
  /// Tets below this that nothing helped are split by a node that may lie near to others and moves
  /// together with them, as long as no tet there gets lower than the lowest was. 0: none.
  double jointly_split_dihedral_deg = 0;
  /// Nodes of tets below this are relaxed at the end, for rounder tets on average. 0: none.
  double relaxed_dihedral_deg = 45;
  int most_passes = 6;
  /// Target edge length at a point: a guard for collapses and splits. Empty: no guard.
  std::function<double(const Vec3&)> spacing;
  /// The smallest target edge length of the job: what an explicit solver's time step hangs on. 0:
  /// not known.
  double smallest_spacing = 0;
  /// Tets lower than this many smallest spacings are raised at the end, and those lower than this
  /// many spacings of their own place. 0: none.
  double height_in_smallest_spacings = 0.55;
  double height_in_spacings = 0;
  /// The worst tets that nothing helped, and the lowest, are tried by moving neighbouring nodes
  /// together, until so many of them could not be helped by that either. Below
  /// `rebuilt_dihedral_deg` the lowest may also be raised for a few per cent of the worst angle.
  std::int64_t most_joint_failures = 0;
  /// Off: the report's angles stay 0, which saves a scan.
  bool measures_angles = true;
  /// Not scanned; only those near a change are looked at.
  RegularTets regular;
  /// Counts tries to better a bad tet, pass after pass.
  WorkProgress progress = {};
};

struct CosmeticReport {
  double min_dihedral_before_deg = 0;
  double min_dihedral_after_deg = 0;
  std::int64_t swaps = 0;
  std::int64_t moves = 0;
  std::int64_t collapses = 0;
  std::int64_t splits = 0;
  std::int64_t reconnections = 0;
  std::int64_t joint_moves = 0;
  /// Tets tried, again and again: what the cost goes with.
  std::int64_t attempts = 0;
};

/// Worst first; no operation makes the worst element of what it touches worse, but for heights that
/// are bought with angles (most_joint_failures). Nodes below
/// `fixed_nodes` and the boundary faces (no neighbour) stay as they are, and so do the nodes of
/// boundary faces. Interior nodes may be moved, removed or added (at the end of points); on return
/// the complex is valid, removed points have node2tet == -1. Angles above 180° less the wanted one
/// count as bad too. Deterministic. Cost: some 50 ns a tet that is not regular, and 10 to 50 µs for
/// each bad tet; on lattice-seeded meshes 0.1 to 0.3 µs a tet in all. Meshes of needles are worked
/// on in stages of counted attempts (staged_improvement.h), 0.15 to 0.3 ms a bad tet.
CosmeticReport improve_mesh(TetComplex& complex, std::int32_t fixed_nodes,
                            const CosmeticOptions& options = {});

}  // namespace tetfarm
