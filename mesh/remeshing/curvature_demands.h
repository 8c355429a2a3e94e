/// How long edges may be where the surface or its curves bend.
///
/// An edge of length l across a curvature of radius r lies off by l^2 / (8 r): at most the
/// tolerance. Besides, a circle gets no fewer than 18 edges, however small. The radius is that of
/// the input's own triangles: their height over the edge between them, by the angle between their
/// normals.
#pragma once

#include <vector>

#include "mesh/remeshing/remesh_options.h"
#include "mesh/remeshing/surface_features.h"
#include "mesh/spacing/surface_spacing.h"

namespace tetfarm {

/// Along edges inside faces, and at vertices of curves; each at least min_size and less than size.
/// @pre the options have been through with_defaults. Cost: O(n + demands). Beyond
/// most_curvature_demands an edge has one, at its middle.
std::vector<PointDemand> curvature_demands(const SurfaceMesh& surface,
                                           const SurfaceFeatures& features,
                                           const RemeshOptions& options);

inline constexpr std::size_t most_curvature_demands = 4'000'000;

}  // namespace tetfarm
