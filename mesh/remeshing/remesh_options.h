/// What a user may ask of remeshing.
///
/// Units: lengths in the unit of the input, degrees.
#pragma once

#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

struct RemeshOptions {
  double size = 0;        ///< wanted edge length; 0: 1/20 of the diagonal of the surface's box
  double min_size = 0;    ///< no edge need be shorter; 0: 1/16 of `size`
  double angle_deg = 30;  ///< edges that are sharper are kept
  double tolerance = 0;   ///< how far from the input; 0: see local_tolerance.h
  double growth = 0.3;    ///< of the spacing for each unit of length
  std::vector<Source> sources;
  /// Whether small faces have a part of `tolerance` only: where that was 0.
  bool has_local_tolerance = false;
  std::vector<TriangleDemand> triangles;  ///< grow no faster than `growth` counts
};

/// The options with every 0 replaced.
/// @throws UsageError when a value cannot be meant: it names the option.
RemeshOptions with_defaults(RemeshOptions options, const SurfaceMesh& surface);

}  // namespace tetfarm
