/// Breaks a bad tet by a new node inside a cavity round it, for tets that nothing else can help:
/// foremost those with four boundary nodes.
///
/// Source: thesis 4.3.4.1, figure 79 (elements formed wholly of boundary nodes), which passes them
/// over; the cavity grows as in B. M. Klingner and J. R. Shewchuk, "Aggressive tetrahedral mesh
/// improvement" (2007), but greedily.
#pragma once

#include <optional>

#include "mesh/cosmetics/cavity.h"

namespace tetfarm::cosmetics {

struct SplitOptions {
  /// Climbing stops at this quality.
  double enough = 0.5;
  /// The new node stays at least this far from the others.
  double least_distance = 0;
  /// The worst may be as bad as it likes, as moves are to follow that make up for it.
  bool takes_any = false;
  /// The tet is so flat that places off its plane are tried too, in large cavities.
  bool is_flat = false;
};

/// The best of: the new node on one of t's inner edges, or in a cavity grown from t where it sees
/// the outer faces best; for a flat tet also in cavities grown from places beside it, on both sides
/// of its plane. Whole layers of flat tets over a nearly flat part of the boundary go that way.
/// Nothing when the worst of the cavity does not get better.
/// Cost: some 1000 qualities, 20,000 for a flat tet; for the few worst tets only.
std::optional<Replacement> find_split(WorkMesh& work, std::int32_t t, const SplitOptions& options);

}  // namespace tetfarm::cosmetics
