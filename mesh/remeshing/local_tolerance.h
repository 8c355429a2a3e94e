/// How much of the tolerance there is at each place.
///
/// A thousandth of the box round everything may be as thick as a wing in a far field: unless the
/// tolerance was asked for, no face has more than two thousandths of its own box.
#pragma once

#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/remeshing/remesh_options.h"
#include "mesh/remeshing/surface_features.h"

namespace tetfarm {

/// For each triangle the part of `tolerance` that its face has: more than 0, 1 at most. Cost: O(n).
std::vector<double> face_shares(const SurfaceMesh& surface, const SurfaceFeatures& features,
                                double tolerance);

/// The same, or 1 everywhere where the tolerance was asked for. @pre the options have been through
/// with_defaults.
std::vector<double> shares_of_tolerance(const SurfaceMesh& surface, const SurfaceFeatures& features,
                                        const RemeshOptions& options);

}  // namespace tetfarm
