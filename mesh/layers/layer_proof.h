/// Whether the layers of a plan are a mesh, and what has to stop earlier so that they are.
///
/// Source: none in the thesis, which tests each new point against the front. Two exact conditions
/// are enough: every tet into which a cell can be divided is positive, and what the layers leave of
/// the domain is bounded by an embedded closed surface that is turned as before. A point that is on
/// neither surface then lies in as many cells as the surface of the domain goes round it more often
/// than that of the rest: in one or none.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/layers/layer_fan.h"
#include "mesh/layers/layer_plan.h"
#include "mesh/layers/wall_planes.h"

namespace tetfarm {

/// For each line the layers that it may keep; those of lines without complaint stay as they are.
struct ProofFindings {
  std::vector<int> stops;
  bool holds = false;  ///< no line has to stop earlier
};

/// How many layers above a triangle with these lines lie below the first cell, from layer `from`
/// on, that is not positive: all of them, where each is. Cost: O(layers).
int positive_layers(const std::array<const LayerLine*, 3>& lines, int from);

/// Whether the first layer of a piece of a fan is positive.
bool has_positive_base(const PieceLines& lines);

/// Looks at each cell: the lines of one that is not positive stop below it. Cost: O(cells).
ProofFindings prove_cells(const LayerPlan& plan, const SurfaceMesh& surface);

/// Looks at the top: where it meets itself or the rest of the surface its lines lose a third of
/// their layers, one at least, and so do lines that leave no region of their planes.
/// Cost: that of check_surface, and that of retreat_planes.
/// @pre prove_cells holds; `planes` are those of the plan's lines.
ProofFindings prove_top(const LayerPlan& plan, const SurfaceMesh& surface,
                        const WallPlanes& planes);

}  // namespace tetfarm
