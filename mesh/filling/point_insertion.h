/// Fills the domain with points by the spacing: the nodes of the job's graded body-centred lattice,
/// as near to the boundary as elements there stay well shaped.
///
/// Source: docs/kernel.md, "Points inside" (a departure from the thesis's sweeps at centroids,
/// [18]; the lattice needs no loop and gives rounder tets); constrained Bowyer–Watson as in thesis
/// 4.3.3. Cost: about 2 µs a tet.
#pragma once

#include <cstdint>
#include <vector>

#include "base/work_progress.h"
#include "mesh/core/tet_complex.h"
#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

struct PointInsertionOptions {
  /// Shortest distance to a boundary face and to a boundary node, in local spacings.
  double face_clearance = 0.5;
  double node_clearance = 0.6;
  WorkProgress progress = {};
};

/// A byte for each node: 1 when it lies in a tet with `inside` set. `core_kinds` are those of
/// core_nodes.h: nodes within reach of one away from the boundary that was met shortly before are
/// not looked up.
std::vector<std::uint8_t> find_inside_nodes(const TetComplex& complex,
                                            const std::vector<std::uint8_t>& inside,
                                            const std::vector<LatticeNode>& nodes,
                                            const std::vector<std::uint8_t>& core_kinds);

/// Appends the nodes to the complex's points and inserts those that keep clear of the boundary:
/// constrained faces and nodes below `boundary_nodes`. The others belong to no tet (node2tet ==
/// -1).
/// @pre the complex reaches beyond the domain on all sides, and the nodes lie inside.
void insert_lattice(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                    std::int32_t boundary_nodes, const std::vector<LatticeNode>& nodes,
                    const PointInsertionOptions& options = {});

}  // namespace tetfarm
