/// Removes an inner edge and fills the hole with the best pairs of tets over its ring of nodes.
///
/// Source: thesis 4.3.4.1 (edge swapping); J. R. Shewchuk, "Two discrete optimization algorithms
/// for the topological improvement of tetrahedral meshes" (2002), with the dynamic programme of G.
/// T. Klincsek (1980) for the triangulation of the ring. A ring of three is the 3-2 swap, a ring of
/// four the 4-4 swap.
#pragma once

#include <array>
#include <optional>

#include "mesh/cosmetics/cavity.h"

namespace tetfarm::cosmetics {

/// The six edges of a tet by their local nodes, that of the largest dihedral angle first: its
/// removal is most likely to help.
std::array<std::array<int, 2>, 6> edges_by_angle(const WorkMesh& work, std::int32_t t);

/// The best way to do without the edge of nodes i and j of tet t; nothing when the edge is on the
/// boundary, has more than ten tets, or when the worst tet does not get better than both the
/// present worst and `beat`. Cost: n³/3 qualities for a ring of n at most, fewer when many are
/// bad.
std::optional<Replacement> find_edge_removal(const WorkMesh& work, std::int32_t t, int i, int j,
                                             double beat);

}  // namespace tetfarm::cosmetics
