/// Fills the domain with the nodes of the job's lattice: those near the boundary and between cells
/// of different size are inserted one by one, the core's tets are written out.
///
/// Source: docs/kernel.md, "Points inside" and "The lattice's own tetrahedra"; lattice_core.h,
/// core_graft.h. The result is the complex that inserting all nodes would give, up to the numbers
/// of tets and nodes, at a fraction of the time and memory: insertion works on the shell only.
/// Cost: 2 µs a tet of the shell, 0.1 µs a tet of the core.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/core/tet_complex.h"
#include "mesh/filling/lattice_core.h"
#include "mesh/filling/lattice_cost.h"
#include "mesh/filling/point_insertion.h"
#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

/// The core that is still to be grafted, when the outside is gone.
struct PendingCore {
  LatticeCore core;
  /// By lattice node: its number in the complex of insert_shell; of core nodes -1.
  std::vector<std::int32_t> node_numbers;
  /// The places of the core nodes, in their order.
  std::vector<Vec3> places;
  /// Of the cells round core nodes.
  double smallest_cell_edge = 0;
  LatticeCost cost;
};

/// Where the core's tets are in the complex after it was grafted.
struct GraftedCore {
  std::int32_t first = 0;
  std::int32_t last = 0;
  /// No tet of the core has a smaller height.
  double least_height = 0;
};

/// Inserts what is not core. `inside` tells the tets of the domain before.
PendingCore insert_shell(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                         const std::vector<std::uint8_t>& inside, const Subdomain& subdomain,
                         const SpacingField& spacing, const PointInsertionOptions& options);

/// Puts the core in. Points from `first_moved` on lie `moved` places lower in the complex than they
/// did in insert_shell.
GraftedCore graft_pending_core(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                               PendingCore pending, std::int32_t first_moved, std::int32_t moved);

}  // namespace tetfarm
