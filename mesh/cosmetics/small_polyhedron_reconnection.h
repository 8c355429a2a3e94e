/// Searches all tetrahedralizations of a small cavity for the one whose worst tet is best: for the
/// few bad tets that swaps, moves, collapses and splits could not help.
///
/// Source: none in the thesis; J. Liu, S. Sun, "Small polyhedron reconnection: a new way to
/// eliminate poorly-shaped tetrahedra" (2006). Branch and bound over the faces that wait for a tet.
/// Their tests whether tets intersect are left out: positive tets whose faces fit tile the cavity
/// (cavity.h).
#pragma once

#include <functional>
#include <optional>

#include "mesh/cosmetics/cavity.h"

namespace tetfarm::cosmetics {

struct ReconnectionOptions {
  /// The cavity grows round the bad tet until it has this many nodes or tets.
  std::size_t most_nodes = 11;
  std::size_t most_tets = 20;
  /// The search is given up after this many tets were tried in a place.
  int most_steps = 4000;
  /// It ends when a tetrahedralization as good as this is found.
  double enough = 0.5;
  /// What is to become larger instead of the quality: a number for a positive tet. Empty: that.
  std::function<double(const Vec3&, const Vec3&, const Vec3&, const Vec3&)> measure;
};

/// A better tetrahedralization of a cavity round tet t; nothing when there is none, or none was
/// found in time. Inner nodes of the cavity that are free to go may be left out.
/// @pre most_nodes <= 12. Cost: 10 µs where a face of the cavity has no good apex, at most some 0.5
/// ms.
std::optional<Replacement> find_reconnection(WorkMesh& work, std::int32_t t,
                                             const ReconnectionOptions& options = {});

}  // namespace tetfarm::cosmetics
