/// The absorbing layers (PML) of a job in the terms of the mesh: which patches they go round, how
/// high they are, and where the outer boundary comes to lie.
///
/// Source: thesis 4.4.3, where a layer is as high as the spacing on the boundary. Shared by the
/// task `inspect` and by the commands that tell what a job would come to. Lengths in the unit of
/// the input.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/job_file/job_file.h"
#include "mesh/layers/layer_request.h"
#include "mesh/layers/pml_blocks.h"

namespace tetfarm {

/// What a job's [[pml]] comes to.
struct PmlFigures {
  std::vector<std::string> patches;  ///< names, in the order of the surface
  int layers = 0;
  double height = 0;  ///< of each
  double thickness = 0;
  std::int64_t triangles = 0;  ///< on the outside, and as many on the inside
  std::int64_t prisms = 0;
  std::int64_t tets = 0;

  std::int64_t cells() const { return prisms + tets; }
};

/// What grows, from where.
struct PmlBlock {
  SurfaceMesh surface;   ///< whose outer boundary is that of the layers
  LayerRequest request;  ///< from there inwards, to where the boundary was if it was moved
  PmlFigures figures;
};

/// The numbers of the patches that [[pml]] names, ascending. Names are matched as those of
/// [[layers]] are (job_layers.h). @pre the job has a [[pml]].
/// @param surface with its outer boundary; need not have been checked.
/// @throws UsageError when a name or pattern matches no patch, or a patch is matched by [[layers]]
/// as well. Cost: O(n).
std::vector<std::int32_t> pml_patches_of(const JobFile& job, const SurfaceMesh& surface);

/// Whether the job's layers are blocks (mesh/layers/pml_blocks.h).
bool has_pml_blocks(const JobFile& job);

/// Of such a job what pml_block_of is of others, but for the surface, which with_pml_blocks makes.
/// @pre the surface has no defects, and bounds one region. @throws UsageError as pml_patches_of and
/// require_pml_blocks do. Cost: that of check_surface.
PmlBlock pml_blocks_of(const JobFile& job, const SurfaceMesh& surface);
PmlBlocksRequest request_of_blocks(const PmlBlock& block);

/// @pre the job has a [[pml]], not of blocks; the surface has no defects, and bounds one region.
/// @throws UsageError as pml_patches_of, pml_directions and moved_outwards do.
/// Cost: that of check_surface.
PmlBlock pml_block_of(const JobFile& job, const SurfaceMesh& surface);

}  // namespace tetfarm
