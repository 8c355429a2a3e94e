/// Which nodes of the lattice are core nodes: those with no boundary and no cell of another size
/// near them.
///
/// Source: kernel notes, "Templates"; lattice_core.h tells why their tets are known.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/spacing/spacing_field.h"
#include "mesh/volume/lattice_grid.h"

namespace tetfarm {

/// No boundary lies nearer to a core node than so many cell edges: its neighbours, up to one edge
/// away, then keep 0.6 spacings clear of it.
inline constexpr double core_reach = 1.56;

/// A byte for each node: 1 when it is a core node, wherever it lies, inside or outside the domain.
/// Cost: O(nodes).
std::vector<std::uint8_t> find_core_nodes(std::span<const LatticeNode> nodes,
                                          const LatticeGrid& grid, const Subdomain& subdomain);

}  // namespace tetfarm
