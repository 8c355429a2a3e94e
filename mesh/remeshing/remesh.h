/// Remeshes a surface: triangles as near to equilateral, and edges as near to the wanted spacing,
/// as its features allow.
///
/// Source: the thesis takes its surface meshes from a generator that it does not describe (1.2).
/// Here: M. Botsch and L. Kobbelt, "A remeshing approach to multiresolution modeling" (2004):
/// collapses, splits, flips and smoothing in turns, each change made only where it has no crossing
/// and stays on the input (surface_replacement.h). Orientation, regions and names of patches as in
/// the input. Units: lengths in the unit of the input.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/remeshing/remesh_options.h"
#include "mesh/remeshing/remeshing_spacing.h"
#include "mesh/remeshing/surface_features.h"

namespace tetfarm {

struct RemeshedSurface {
  SurfaceMesh surface;
  std::vector<std::array<std::int32_t, 2>> feature_edges;  ///< low < high, sorted
};

/// The result is closed and has no crossings, as the input; its corners are the input's, to the
/// last bit. No vertex of the input is farther from it than the tolerance, unless it still is after
/// four rounds in which such vertices were made corners. Deterministic. @pre check_surface found no
/// defect; options have been through with_defaults. Cost: some 50 µs and 500 bytes for each
/// triangle made and each given.
RemeshedSurface remesh(const SurfaceMesh& surface, const SurfaceFeatures& features,
                       const RemeshingSpacing& spacing, const RemeshOptions& options);

}  // namespace tetfarm
