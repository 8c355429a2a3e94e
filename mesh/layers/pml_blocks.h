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

#include "mesh/core/surface_mesh.h"
#include "mesh/layers/height_law.h"
#include "mesh/layers/layer_plan.h"

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

/// @param patches of the surface, ascending. @pre as of with_pml_blocks. @throws UsageError as
/// with_pml_blocks does where the patches are not such faces. Cost: O(n log n).
PmlBlockCounts counts_of_pml_blocks(const SurfaceMesh& surface,
                                    std::span<const std::int32_t> patches, int layers);

/// Adds the blocks to a surface of one region without defects. On the patches, whose triangles have
/// to lie in the planes of the box round the surface, vertices are moved within rounding, so that
/// the nodes of blocks that meet are the same to the last bit.
/// @param plan of the surface's other layers, which end elsewhere. @param law of layers of equal
/// height, `layers` of them.
/// @throws UsageError naming the place where a triangle lies in no such plane, other layers are at
/// one, layers are too low for the coordinates, or the outside would meet itself.
/// Cost: O(cells), and that of check_surface.
PmlBlocks with_pml_blocks(const SurfaceMesh& surface, const LayerPlan& plan,
                          std::span<const std::int32_t> patches, const HeightLaw& law, int layers);

}  // namespace tetfarm
