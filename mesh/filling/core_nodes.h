/// Which nodes of the lattice are core nodes: those with no cell of another size near them, and no
/// boundary but faces of the lattice itself.
///
/// Source: docs/kernel.md, "The lattice's own tetrahedra"; lattice_core.h tells why their tets are
/// known.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/filling/lattice_boundary.h"
#include "mesh/filling/lattice_grid.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

/// No other boundary lies nearer to a core node than so many cell edges: its neighbours, up to one
/// edge away, then keep 0.6 spacings clear of it.
inline constexpr double core_reach = 1.56;

enum CoreKind : std::uint8_t {
  not_core = 0,
  core_away = 1,    ///< no boundary within its reach
  core_at_cut = 2,  ///< faces of the lattice that are on the boundary may be within its reach
};

/// The kind of each node, wherever it lies, inside or outside the domain. A node in the place of a
/// vertex of the boundary is not core. `tree` is of the boxes of the boundary's triangles.
/// Cost: O(nodes).
std::vector<std::uint8_t> find_core_nodes(std::span<const LatticeNode> nodes,
                                          const LatticeGrid& grid, const Subdomain& subdomain,
                                          const BoxTree& tree, const LatticeBoundary& boundary);

}  // namespace tetfarm
