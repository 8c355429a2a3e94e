/// Blocks of absorbing layers (PML) beyond planes that bound the domain: one over each face, and
/// where faces meet one over their edge, whose cells lie beyond both of them, and one over their
/// corner. Round a box these are 6, 12 and 8, and the outside is a larger box.
///
/// Source: none in the thesis, whose layers have one line at a node. Faces are extruded one after
/// the other, those across x first, then y and z, each with the sides of the blocks before it: a
/// line of nodes is straight, along an axis, and may end on one of an axis before. The lines run
/// from the outside inwards, as those of other absorbing layers do, so that the surface is the
/// outside. What the faces end at, such as a plane of symmetry, is carried on by the blocks' sides.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/layers/height_law.h"
#include "mesh/layers/layer_plan.h"
#include "mesh/layers/layer_request.h"

namespace tetfarm {

/// What the blocks come to.
struct PmlBlockCounts {
  std::int64_t outer_triangles = 0;  ///< that the patches have then
  std::int64_t tets = 0;
};

/// The faces in triangles, the layers above these, and what the domain was made into.
struct PmlBlocks {
  /// Vertices and triangles keep their numbers; those on the patches are on the outside.
  SurfaceMesh surface;
  LayerPlan plan;  ///< with the lines of all layers
};

/// What grows where.
struct PmlBlocksRequest {
  std::vector<std::int32_t> patches;  ///< of the surface, ascending
  HeightLaw law;                      ///< of layers of equal height
  int layers = 1;
};

/// @pre the surface has one region and no defects, here and below. @throws UsageError naming the
/// place where a triangle of the patches lies in no plane of the box round the surface.
/// Cost: O(n log n).
PmlBlockCounts counts_of_pml_blocks(const SurfaceMesh& surface, const PmlBlocksRequest& request);

/// @param others what grows from other patches. @throws UsageError as counts_of_pml_blocks does,
/// and naming the place where one of the others meets the patches, or where the outside would meet
/// itself. Cost: that of check_surface.
void require_pml_blocks(const SurfaceMesh& surface, const PmlBlocksRequest& request,
                        std::span<const LayerRequest> others);

/// Adds the blocks. On the patches vertices are moved within rounding, so that the nodes of blocks
/// that meet are the same to the last bit.
/// @param plan of the surface's other layers, which may have sides in planes.
/// @pre require_pml_blocks accepts the surface as it was before there were such sides.
/// @throws UsageError naming the place where layers are too low for the coordinates.
/// Cost: O(cells).
PmlBlocks with_pml_blocks(const SurfaceMesh& surface, LayerPlan plan,
                          const PmlBlocksRequest& request);

}  // namespace tetfarm
