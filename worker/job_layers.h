/// The boundary layers of a job in the terms of the mesh: which patches they grow on, how high they
/// are, and what stands in their way before anything is meshed.
///
/// Source: none in the thesis, whose user names the patches. Shared by the task `inspect` and by
/// the commands that tell what a job would come to. Lengths in the unit of the input.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/job_file/job_file.h"
#include "mesh/layers/layer_request.h"

namespace tetfarm {

/// One for each [[layers]] of the job, in its order. A surface without patches has one, 0, which is
/// called "surface". The outer boundary that the job puts round a body is not matched but by names
/// that begin with "outer".
/// @param surface with its outer boundary; need not have been checked.
/// @throws UsageError when a name or pattern matches no patch, a patch is matched by two
/// [[layers]], the layers cannot become as high as asked, or the first is higher than the median
/// edge of the patches. Cost: O(n) for n triangles, and O(patterns · patches).
std::vector<LayerRequest> layer_requests_of(const JobFile& job, const SurfaceMesh& surface);

/// What one [[layers]] comes to at the median edge of its patches.
struct LayerFigures {
  std::vector<std::string> patches;  ///< names, in the order of the surface
  std::int64_t triangles = 0;
  double median_edge = 0;  ///< 0: it has no triangles, and nothing below is known
  int layers = 0;
  double first_height = 0;
  double last_height = 0;
  double total_height = 0;
  bool in_tets = false;     ///< cells are divided into tets
  int isotropic_layer = 0;  ///< the first that is as high as isotropic_share of the edges; 0: none
};

/// In the order of layer_requests_of, which see.
std::vector<LayerFigures> layer_figures_of(const JobFile& job, const SurfaceMesh& surface);

}  // namespace tetfarm
