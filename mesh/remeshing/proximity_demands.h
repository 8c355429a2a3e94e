/// How long edges may be where the surface comes near to itself: three across a thin part or a gap,
/// one across a strip between two feature curves, and as long as an edge between two corners.
///
/// A part is thin, or a gap narrow, where a ray along the normal meets a triangle that faces it,
/// with normals within 8 degrees: a wedge is neither, else a sharp edge would ask for nothing but
/// the smallest size. Likewise a strip lies between feature edges that are nearly parallel.
#pragma once

#include <vector>

#include "mesh/remeshing/remesh_options.h"
#include "mesh/remeshing/surface_features.h"
#include "mesh/spacing/surface_spacing.h"

namespace tetfarm {

/// Each less than size, and at least min_size but for edges between corners, which stay as they
/// are. Rays start from points of the triangles `size` apart, one a triangle at least, and where
/// walls are found, as near as these are; strips are looked for from points of the feature edges as
/// near to each other as the strip may be narrow. No more than most_proximity_samples points of
/// each kind: farther apart, where there would be more.
/// @pre the options have been through with_defaults. Cost: O(samples log n), and what lies near the
/// rays.
std::vector<PointDemand> proximity_demands(const SurfaceMesh& surface,
                                           const SurfaceFeatures& features,
                                           const RemeshOptions& options);

inline constexpr double most_proximity_samples = 1e6;

}  // namespace tetfarm
