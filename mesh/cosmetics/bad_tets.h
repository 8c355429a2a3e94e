/// Finds what cosmetics is to work on: bad tets, and nodes to relax.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/cosmetics/cavity.h"
#include "mesh/cosmetics/improve_mesh.h"

namespace tetfarm::cosmetics {

/// A tet to work on. Stale when the tet is dead or its quality has changed: it is then queued
/// anew.
struct BadTet {
  double quality;
  std::int32_t tet;

  friend bool operator==(const BadTet& a, const BadTet& b) = default;
  /// The worst comes first out of a priority queue.
  friend bool operator<(const BadTet& a, const BadTet& b) {
    return a.quality != b.quality ? a.quality > b.quality : a.tet > b.tet;
  }
};

struct BadTetScan {
  double min_dihedral_deg = 0;
  std::vector<double> tet2quality;
  std::vector<BadTet> bad;
  /// Set for the nodes of tets to relax; empty when there are none.
  std::vector<bool> to_relax;
};

/// The qualities below which a tet is bad, and below which its nodes are relaxed.
struct QualityLimits {
  double wanted = 0;
  double relaxed = 0;
};

/// Regular tets are looked at only where they may be bad. Cost: 50 ns a tet.
BadTetScan scan_for_bad_tets(const TetComplex& complex, const QualityLimits& limits,
                             const CosmeticOptions& options);

/// The smallest dihedral angle of the mesh. Cost: that of a quality for each tet whose is not
/// known.
double min_dihedral_deg(const WorkMesh& work, const RegularTets& regular);

}  // namespace tetfarm::cosmetics
