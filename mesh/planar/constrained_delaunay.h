/// The constrained Delaunay triangulation of a planar region: its own points only, all its edges.
///
/// Source: thesis 3.1 (Bowyer-Watson from two triangles round everything, then boundary recovery by
/// edge swapping); S. W. Sloan, "A fast algorithm for generating constrained Delaunay
/// triangulations" (1993) for the swapping. The thesis computes with rounding; here every decision
/// is exact, and of cocircular points the diagonal that is there stays.
#pragma once

#include <optional>

#include "mesh/planar/planar_mesh.h"
#include "mesh/planar/triangle_complex.h"

namespace tetfarm {

struct ConstrainedDelaunay {
  /// The region's triangles; points as in the region. Its edges are constrained, and have nothing
  /// on the other side.
  TriangleComplex complex;
  std::optional<PlanarFailure> failure;
};

/// Triangulates the region. A point that no edge uses becomes an inner node if it lies inside.
/// The result does not depend on the order of the edges. What makes it fail: see mesh_region.
/// Cost: O(n log n) for loops whose edges the Delaunay triangulation mostly has by itself.
ConstrainedDelaunay constrained_delaunay(const PlanarRegion& region);

}  // namespace tetfarm
